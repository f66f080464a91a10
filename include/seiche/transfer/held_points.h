// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_held_points_h
#define seiche_transfer_held_points_h

#include <seiche/transfer/point_block.h>
#include <seiche/transfer/wall_faces.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  /// det(I + grad u) of a step, and of half of it, that no point may fall
  /// below: a cell folds over soon.
  constexpr double least_det_F = 0.2;

  /// |J - 1| of a point that is held, at most [-]: drops far off would ask for
  /// an increment that no step size makes small.
  constexpr double largest_volume_error = 0.25;

  /**
   * @brief Bounds of what points do in steps that are accepted although they
   * have failed (prm entry "Time/Failing steps").
   *
   * A point goes the largest share 1, 1/2, 1/4, ... of its way on which its
   * volume, also half-way, keeps the share @p least_det_F of what it was, on
   * which it moves no farther than a limit and not through a wall; none of it
   * where 1/64 would still be too much. The volume ratio of such a point stays
   * within largest_volume_error of one; its velocity is the grid's all the
   * same.
   */
  template <int dim>
  class HeldPoints
  {
  public:
    /// @p largest_way [cells]; infinity: no point is held.
    explicit HeldPoints(const double largest_way)
      : limit(largest_way)
    {}

    bool
    any_may_be() const
    {
      return std::isfinite(limit);
    }

    /// Shorten the ways u [m] and F = I + grad u of the first @p n_filled
    /// points of a block, at the places @p x [m]; @p reach: the way of a cell
    /// [m]; @p walls: WallFaces of the cell; @p is_held: of which this was
    /// done.
    template <typename Walls>
    void
    shorten(const dealii::Tensor<1, dim>          &reach,
            const Walls                           &walls,
            const std::array<const double *, dim> &x,
            const unsigned int                     n_filled,
            double (&F)[dim][dim][n_lanes],
            double (&u)[dim][n_lanes],
            bool (&is_held)[n_lanes]) const
    {
      for (unsigned int l = 0; l < n_filled; ++l)
        {
          dealii::Tensor<2, dim> H;
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              H[c][d] = F[c][d][l] - (c == d ? 1. : 0.);
          const auto stands = [&](const double share) {
            bool result =
              keeps_volume(share * H) && keeps_volume(0.5 * share * H);
            for (unsigned int c = 0; c < dim; ++c)
              result = result &&
                       share * std::abs(u[c][l]) <= limit * reach[c] &&
                       walls.way_beyond(c, x[c][l] + share * u[c][l]) <=
                         wall_tolerance;
            return result;
          };
          double share = 1.;
          while (share > 0. && !stands(share))
            share = share > smallest_share ? 0.5 * share : 0.;
          is_held[l] = share < 1.;
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

    static bool
    keeps_volume(dealii::Tensor<2, dim> H)
    {
      for (unsigned int d = 0; d < dim; ++d)
        H[d][d] += 1.;
      return dealii::determinant(H) >= least_det_F;
    }

    const double limit; // [cells]
  };
} // namespace seiche

#endif
