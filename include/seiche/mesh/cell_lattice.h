// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_cell_lattice_h
#define seiche_mesh_cell_lattice_h

#include <seiche/mesh/grid_lines.h>
#include <seiche/mesh/periods.h>
#include <seiche/utilities/box_face.h>

#include <deal.II/base/numbers.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace seiche
{
  /**
   * @brief Where the own and ghost cells of this rank lie on the finest lattice
   * (GridLines): each is a box of 2^n lattice cells a direction.
   */
  template <int dim>
  class CellLattice
  {
  public:
    using Index = typename GridLines<dim>::Index;
    using CellIterator =
      typename dealii::Triangulation<dim>::active_cell_iterator;

    /// References must outlive the object.
    CellLattice(const GridLines<dim> &lines, const Periods<dim> &periods);

    /// After a change of the mesh: cells in the order of their local numbers.
    void
    reinit(const std::vector<CellIterator> &cells);

    /// Own or ghost cell that covers a lattice cell, or
    /// numbers::invalid_unsigned_int.
    unsigned int
    find(const Index &index) const;

    /// The box of a cell between its lines.
    CellGeometry<dim>
    geometry(const unsigned int cell) const
    {
      return lines.box(lower[cell], upper[cell]);
    }

    /// Number of lattice cells along an edge of the cell.
    unsigned int
    size(const unsigned int cell) const
    {
      return upper[cell][0] - lower[cell][0];
    }

    /// Place in a cell in halves of its edges (0, 1, 2 per direction), as
    /// halves of lattice cells, the same on both sides of a seam.
    Index
    place(const unsigned int cell, const Index &halves) const;

    /// Global index, x fastest, of a lattice cell inside a cell, @p offset from
    /// its lowest: the same on every rank count and mesh.
    std::uint64_t
    index(const unsigned int cell, const Index &offset = {}) const;

    /// Number of lattice cells; a double holds it where 64 bits do not.
    double
    n_lattice_cells() const;

    /// Box of that lattice cell.
    dealii::BoundingBox<dim>
    box(const unsigned int cell, const Index &offset) const;

    /// True if the cell's face is on a periodic side, or one of its faces.
    bool
    at_seam(const unsigned int cell, const BoxFace face) const
    {
      const unsigned int d = face.direction();
      return periods.in(d) &&
             (face.is_upper() ? upper[cell][d] == lines.n_cells(d) :
                                lower[cell][d] == 0);
    }
    bool
    at_seam(const unsigned int cell) const;

    /// Own or ghost cell beyond the seam, at the cell's lowest corner.
    unsigned int
    across_seam(const unsigned int cell, const BoxFace face) const;

  private:
    bool
    covers(const unsigned int cell, const Index &index) const;

    const GridLines<dim> &lines;
    const Periods<dim>   &periods;
    std::vector<Index>    lower;
    std::vector<Index>    upper; // exclusive
    // (Morton key of the lower lattice corner, cell), sorted by key: the cells
    // of a forest of 2^n-refined boxes are intervals of this order
    std::vector<std::pair<std::uint64_t, unsigned int>> by_key;
  };
} // namespace seiche

#endif
