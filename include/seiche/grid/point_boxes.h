// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_point_boxes_h
#define seiche_grid_point_boxes_h

#include <seiche/space/occupancy.h>

#include <array>

namespace seiche
{
  /**
   * @brief Integrals of the hat functions of FE_Q(1) over the boxes that points
   * stand for, <N_I> of doc/theory.md (5.0a) (compare GIMP: Bardenhagen and
   * Kober 2004).
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

    /// Add the means over the boxes of an own cell's points, times their
    /// @p volume [points], to @p sums, which belong to own and ghost nodes.
    /// Local.
    void
    add(const PointCloud<dim>           &points,
        const double                    *volume,
        const unsigned int               cell,
        typename Occupancy<dim>::Vector &sums) const;

  private:
    static constexpr unsigned int n_sides = dim == 2 ? 9 : 27;

    /// A part of a box along an axis, in the cell that holds it.
    struct Part
    {
      unsigned int
             side;     ///< this cell's: below, in, above the box's own: 0, 1, 2
      double hats[2];  ///< mean of the lower and the upper hat, times the
                       ///< part's share of the box [-]
      double from, to; ///< in the unit cell of the box's own
      double fold_from, fold_to; ///< what a wall folds back, or nothing
    };

    /// What the cell and those around it hold.
    struct Integrals
    {
      std::array<unsigned int, n_sides>                  holder;
      std::array<std::array<double, 1u << dim>, n_sides> of_vertices;
      std::array<bool, n_sides>                          exists{};
    };

    /// The parts on both sides of a face, or the whole box; their number.
    unsigned int
    divide(const unsigned int cell,
           const unsigned int direction,
           const double       centre,
           const double       edge,
           Part (&parts)[2]) const;

    /// The cell that touches this one where a place of its unit cell is or
    /// would be (cells beyond it may be unknown to this rank); this one around
    /// the edge of an obstacle.
    unsigned int
    find_touching(const unsigned int        cell,
                  const dealii::Point<dim> &unit) const;

    /// The cell that holds parts on a side; invalid if cells have another size
    /// there.
    unsigned int
    find_holder(const unsigned int cell, const unsigned int side) const;

    /// @p part: of each direction.
    void
    add_part(const unsigned int               cell,
             const std::array<Part, dim>     &part,
             const double                     edge,
             const double                     volume,
             Integrals                       &integrals,
             typename Occupancy<dim>::Vector &sums) const;

    /// Where cells are smaller or larger: piece by piece, so that at a level
    /// jump it is all the same which of two cells holds a point on their face.
    void
    add_elsewhere(const unsigned int               cell,
                  const std::array<Part, dim>     &part,
                  const double                     edge,
                  const double                     volume,
                  typename Occupancy<dim>::Vector &sums) const;

    /// Content at a place in the unit cell of @p cell.
    void
    add_at(const unsigned int               cell,
           const dealii::Point<dim>        &unit,
           const double                     content,
           typename Occupancy<dim>::Vector &sums) const;

    const Occupancy<dim> &occupancy;
  };
} // namespace seiche

#endif
