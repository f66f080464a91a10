// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_point_shift_h
#define seiche_grid_point_shift_h

#include <seiche/points/point_cloud.h>

#include <deal.II/base/bounding_box.h>

#include <array>

namespace seiche
{
  /**
   * @brief Moves points of one cell between two steps, without the flow.
   *
   * A shift is shortened before the cell's walls: the distance a from one
   * becomes a^2/(a + |delta|) (doc/theory.md (5.4)), where sides of the domain
   * that move are taken where they are by then. No point goes around the edge
   * of an obstacle. Its velocity follows by the gradient that it carries, by a
   * share: all of it in spray feeds on itself (doc/theory.md (5.1)).
   */
  template <int dim>
  class PointShift
  {
  public:
    /// @p domain: the box of the walls where the points are now; it must
    /// outlive the object.
    PointShift(const unsigned int              own_cell,
               PointCloud<dim>                &points,
               const dealii::BoundingBox<dim> &domain);

    /// @p delta [cells]
    void
    apply(const std::size_t      point,
          dealii::Tensor<1, dim> delta,
          const double           velocity_share) const;

  private:
    const unsigned int              cell;
    PointCloud<dim>                &points;
    const dealii::BoundingBox<dim> &domain;
    std::array<bool, 2 * dim>       is_wall; ///< face
    std::array<double *, dim>       position, velocity;
    /// d v_c/d x_d at c dim + d; null if points carry none
    std::array<const double *, dim * dim> gradient;
  };
} // namespace seiche

#endif
