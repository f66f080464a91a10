// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_point_boxes_h
#define seiche_grid_point_boxes_h

#include <seiche/grid/occupancy.h>

namespace seiche
{
  /**
   * @brief Integrals of the hat functions of FE_Q(1) over the boxes that points
   * stand for (compare GIMP: Bardenhagen and Kober 2004).
   *
   * A point's box has the shape of its cell and the point's volume, at most the
   * cell's, and lies inside the domain. With the hats' values at the points
   * instead, the fill at a surface that crosses a grid line is wrong by up to
   * an eighth of the spacing squared.
   */
  template <int dim>
  class PointBoxes
  {
  public:
    /// @p occupancy must outlive the object.
    explicit PointBoxes(const Occupancy<dim> &occupancy);

    /// Add the integrals over the box of a point at @p unit in an own cell to
    /// @p sums, which belong to own and ghost nodes. Local.
    void
    add(const unsigned int               cell,
        const dealii::Point<dim>        &unit,
        const double                     volume,
        typename Occupancy<dim>::Vector &sums) const;

  private:
    /// Parts of a box along an axis, on both sides of a face of the cell.
    struct Parts
    {
      unsigned int n = 1;
      double       centre[2], share[2]; ///< [unit cell], [-]
    };

    Parts
    divide(const unsigned int cell,
           const unsigned int direction,
           const double       centre,
           const double       edge) const;

    const Occupancy<dim> &occupancy;
  };
} // namespace seiche

#endif
