// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_held_points_h
#define seiche_transfer_held_points_h

#include <seiche/transfer/point_block.h>

#include <cmath>

namespace seiche
{
  /// det(I + grad u) of a step, and of half of it, that no point may fall
  /// below: a cell folds over soon.
  constexpr double least_det_F = 0.2;

  /**
   * @brief Points of a block that go only a part of their way, in steps that
   * are accepted whatever they do (prm entry "Time/Failing steps").
   *
   * A point goes the largest share 1, 1/2, 1/4, ... of u on which its volume
   * changes by @p least_det_F at least and on which it moves no farther than
   * a limit; none at all where 1/64 would still be too much. As for a step that
   * is not accepted, the half-way volume counts too.
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
    /// points of a block. @p reach: the way of a cell [m]. The number of points
    /// that were held.
    unsigned int
    shorten(double (&F)[dim][dim][n_lanes],
            double (&u)[dim][n_lanes],
            const dealii::Tensor<1, dim> &reach,
            const unsigned int            n_filled) const
    {
      unsigned int n_held = 0;
      for (unsigned int l = 0; l < n_filled; ++l)
        {
          dealii::Tensor<2, dim> H;
          double                 way = 0.;
          for (unsigned int c = 0; c < dim; ++c)
            {
              way = std::max(way, std::abs(u[c][l]) / reach[c]);
              for (unsigned int d = 0; d < dim; ++d)
                H[c][d] = F[c][d][l] - (c == d ? 1. : 0.);
            }
          double share = 1.;
          while (share > 0. && !(share * way <= limit && keeps(share * H) &&
                                 keeps(0.5 * share * H)))
            share = share > smallest_share ? 0.5 * share : 0.;
          if (share == 1.)
            continue;
          ++n_held;
          for (unsigned int c = 0; c < dim; ++c)
            {
              u[c][l] *= share;
              for (unsigned int d = 0; d < dim; ++d)
                F[c][d][l] = share * H[c][d] + (c == d ? 1. : 0.);
            }
        }
      return n_held;
    }

    /// A factor of the volume in a step: nodal means may crush points that
    /// are not held themselves.
    double
    bounded(const double factor) const
    {
      return any_may_be() ? std::max(factor, least_det_F) : factor;
    }

  private:
    static constexpr double smallest_share = 1. / 64.;

    /// Is det(I + H) large enough?
    static bool
    keeps(dealii::Tensor<2, dim> H)
    {
      for (unsigned int d = 0; d < dim; ++d)
        H[d][d] += 1.;
      return dealii::determinant(H) >= least_det_F;
    }

    const double limit; // [cells]
  };
} // namespace seiche

#endif
