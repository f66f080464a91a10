// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_held_points_h
#define seiche_transfer_held_points_h

#include <seiche/constitutive/volume_law.h>
#include <seiche/points/cell_locator.h>
#include <seiche/transfer/point_block.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  /// det(I + grad u) of a step, and of half of it, that no point may fall
  /// below: a cell folds over soon.
  constexpr double least_det_F = 0.2;

  /**
   * @brief Bounds of what points do in steps that are accepted although they
   * have failed (prm entry "Time/Failing steps").
   *
   * A point goes the largest share 1, 1/2, 1/4, ... of its way on which its
   * volume, also half-way, keeps the share @p least_det_F of what it was, on
   * which it moves no farther than a limit and not through a wall; none of it
   * where 1/64 would still be too much. Its volume ratio stays within
   * largest_volume_error of one.
   */
  template <int dim>
  class HeldPoints
  {
  public:
    /// @p largest_way [cells]; infinity: no point is held.
    HeldPoints(const CellLocator<dim> &cell_locator, const double largest_way)
      : locator(cell_locator)
      , limit(largest_way)
    {}

    bool
    any_may_be() const
    {
      return std::isfinite(limit);
    }

    /// Shorten the ways u [m] and F = I + grad u of the first @p n_filled
    /// points of a block of the cell, at the places @p x [m]; @p is_held: of
    /// which this was done.
    void
    shorten(const unsigned int                     cell,
            const std::array<const double *, dim> &x,
            const unsigned int                     n_filled,
            double (&F)[dim][dim][n_lanes],
            double (&u)[dim][n_lanes],
            bool (&is_held)[n_lanes]) const
    {
      for (unsigned int l = 0; l < n_filled; ++l)
        {
          dealii::Point<dim>     here;
          dealii::Tensor<1, dim> way;
          dealii::Tensor<2, dim> H;
          for (unsigned int c = 0; c < dim; ++c)
            {
              here[c] = x[c][l];
              way[c]  = u[c][l];
              for (unsigned int d = 0; d < dim; ++d)
                H[c][d] = F[c][d][l] - (c == d ? 1. : 0.);
            }
          const double share = largest_share(cell, here, way, H);
          is_held[l]         = share < 1.;
          if (!is_held[l])
            continue;
          for (unsigned int c = 0; c < dim; ++c)
            {
              u[c][l] *= share;
              for (unsigned int d = 0; d < dim; ++d)
                F[c][d][l] = share * H[c][d] + (c == d ? 1. : 0.);
            }
        }
    }

    /// The volume ratio [-] within its bounds.
    static double
    bounded(const double ratio)
    {
      return std::clamp(ratio,
                        1. - largest_volume_error,
                        1. + largest_volume_error);
    }

  private:
    static constexpr double smallest_share = 1. / 64.;

    double
    largest_share(const unsigned int            cell,
                  const dealii::Point<dim>     &x,
                  const dealii::Tensor<1, dim> &u,
                  const dealii::Tensor<2, dim> &H) const
    {
      double share = 1.;
      while (!(keeps_volume(share * H) && keeps_volume(0.5 * share * H) &&
               is_near(cell, share * u) && is_inside(x + share * u)))
        {
          if (share <= smallest_share)
            return 0.;
          share *= 0.5;
        }
      return share;
    }

    static bool
    keeps_volume(dealii::Tensor<2, dim> H)
    {
      for (unsigned int d = 0; d < dim; ++d)
        H[d][d] += 1.;
      return dealii::determinant(H) >= least_det_F;
    }

    bool
    is_near(const unsigned int cell, const dealii::Tensor<1, dim> &u) const
    {
      bool result = true;
      for (unsigned int d = 0; d < dim; ++d)
        result = result && std::abs(u[d]) <= limit * locator.reach(cell)[d];
      return result;
    }

    /// Inside the walls, or beyond an open side.
    bool
    is_inside(const dealii::Point<dim> &x) const
    {
      const auto wall = locator.wall_beyond(x);
      return wall == dealii::numbers::internal_face_boundary_id ||
             locator.grid.wall_condition(wall) == WallCondition::open;
    }

    const CellLocator<dim> &locator;
    const double            limit; // [cells]
  };
} // namespace seiche

#endif
