// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_zero_components_h
#define seiche_space_zero_components_h

#include <seiche/space/cell_unknowns.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Components of vector fields that are zero at nodes of single cells,
   * whatever the unknowns are: at faces of obstacles whose edges are free
   * (doc/theory.md (8.0c)).
   */
  template <int dim>
  class ZeroComponents
  {
  public:
    /// None.
    void
    clear()
    {
      place_of_cell.clear();
      bits.clear();
      some_exist = false;
    }

    /// A component is zero at node @p a of the element of this degree of one
    /// of @p n_cells own and ghost cells.
    void
    add(const unsigned int cell,
        const unsigned int n_cells,
        const unsigned int degree,
        const unsigned int component,
        const unsigned int a)
    {
      place_of_cell.resize(n_cells, 0);
      if (place_of_cell[cell] == 0)
        {
          bits.emplace_back();
          place_of_cell[cell] = bits.size();
        }
      bits[place_of_cell[cell] - 1][degree - 1][component] |= 1u << a;
    }

    /// Those of a cell's element; null: none.
    const ComponentBits<dim> *
    in(const unsigned int cell, const unsigned int degree) const
    {
      return place_of_cell.empty() || place_of_cell[cell] == 0 ?
               nullptr :
               &bits[place_of_cell[cell] - 1][degree - 1];
    }

    /// True if there are some on any rank, once share() has been called.
    bool
    exist() const
    {
      return some_exist;
    }

    /// Collective.
    void
    share(const MPI_Comm communicator)
    {
      some_exist =
        dealii::Utilities::MPI::logical_or(!bits.empty(), communicator);
    }

  private:
    /// By own and ghost cell, one more than its place in bits; 0: none.
    std::vector<unsigned int>                      place_of_cell;
    std::vector<std::array<ComponentBits<dim>, 2>> bits; ///< by degree - 1
    bool                                           some_exist = false;
  };
} // namespace seiche

#endif
