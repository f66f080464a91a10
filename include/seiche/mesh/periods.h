// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_periods_h
#define seiche_mesh_periods_h

#include <seiche/mesh/grid_lines.h>

#include <deal.II/base/tensor.h>

namespace seiche
{
  /**
   * @brief Places in a domain with periodic sides: those that differ by a
   * period are one.
   */
  template <int dim>
  class Periods
  {
  public:
    /// @p lines must outlive the object.
    explicit Periods(const GridLines<dim> &lines);

    /// True if the two sides across @p direction are one place.
    bool
    in(const unsigned int direction) const
    {
      return periodic[direction];
    }

    /// Where @p x is inside the domain if it is beyond a periodic side: half
    /// open, [lower, upper). Other coordinates stay.
    dealii::Point<dim>
    wrapped(const dealii::Point<dim> &x) const
    {
      return exist ? wrapped_at_seam(x) : x;
    }

    /// @p x moved by periods so that it is nearest to the cell.
    dealii::Point<dim>
    image(const dealii::Point<dim> &x, const CellGeometry<dim> &cell) const
    {
      return exist ? image_at_seam(x, cell) : x;
    }

    /// @p x in periodic directions as difference of two places: the least.
    dealii::Tensor<1, dim>
    shortest(const dealii::Tensor<1, dim> &x) const
    {
      return exist ? shortest_at_seam(x) : x;
    }

  private:
    // asked for by every point and piece of the surface: a call only where
    // there is a seam
    dealii::Point<dim>
    wrapped_at_seam(const dealii::Point<dim> &x) const;
    dealii::Point<dim>
    image_at_seam(const dealii::Point<dim> &x,
                  const CellGeometry<dim>  &cell) const;
    dealii::Tensor<1, dim>
    shortest_at_seam(const dealii::Tensor<1, dim> &x) const;

    const GridLines<dim> &lines;
    std::array<bool, dim> periodic;
    const bool            exist; // in some direction
  };
} // namespace seiche

#endif
