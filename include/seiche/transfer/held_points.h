// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_held_points_h
#define seiche_transfer_held_points_h

#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/wall_faces.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace seiche
{
  /// det(I + grad u) of a step, and of half of it, that no point may fall
  /// below: a cell folds over soon.
  constexpr double least_det_F = 0.2;

  /// |J - 1| of a point that is held, at most [-]: drops far off would ask for
  /// an increment that no step size makes small.
  constexpr double largest_volume_error = 0.25;

  /// For the points of a batch.
  using HeldFlags = std::array<bool, n_lanes_of_register>;

  /**
   * @brief Bounds of what points do in steps that are accepted although they
   * have failed (prm entry "Time/Failing steps"; doc/theory.md (10.2)).
   *
   * A point goes the largest share 1, 1/2, 1/4, ... of its way on which its
   * volume, also half-way, keeps the share @p least_det_F of what it was, on
   * which it moves no farther than a limit and not through a wall of WallFaces;
   * none of it where 1/64 would still be too much. The volume ratio of such a
   * point stays within largest_volume_error of one; its velocity is the grid's
   * all the same.
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

    /// Shorten the ways @p u [m] and @p H = grad u of the first @p n_filled
    /// points of a batch, at the places @p x [m]; @p reach: the way of a cell
    /// [m]; @p walls: WallFaces of the cell. Of which points this was done.
    template <typename Walls>
    HeldFlags
    shorten(const dealii::Tensor<1, dim>    &reach,
            const Walls                     &walls,
            const dealii::Point<dim, Lanes> &x,
            const unsigned int               n_filled,
            dealii::Tensor<2, dim, Lanes>   &H,
            dealii::Tensor<1, dim, Lanes>   &u) const
    {
      HeldFlags is_held = {};
      for (unsigned int l = 0; l < n_filled; ++l)
        {
          dealii::Tensor<2, dim> H_l;
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              H_l[c][d] = H[c][d][l];
          const auto stands = [&](const double share) {
            bool result =
              keeps_volume(share * H_l) && keeps_volume(0.5 * share * H_l);
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
              u[c][l] = share * u[c][l];
              for (unsigned int d = 0; d < dim; ++d)
                H[c][d][l] = share * H_l[c][d];
            }
        }
      return is_held;
    }

    /// The volume ratio [-] within its bounds.
    static double
    bounded(const double ratio)
    {
      return std::clamp(ratio,
                        1. - largest_volume_error,
                        1. + largest_volume_error);
    }

    /// Volume ratios [-] of a batch times @p change; of held points times what
    /// is their @p own, within bounds. How many are held.
    static std::size_t
    update_volume(const Lanes      &change,
                  const Lanes      &own,
                  const HeldFlags  &is_held,
                  const PointRange &range,
                  double           *ratios)
    {
      const Lanes before = range.load(ratios);
      Lanes       after  = before * change;
      std::size_t n_held = 0;
      for (unsigned int l = 0; l < range.size; ++l)
        if (is_held[l])
          {
            ++n_held;
            after[l] = bounded(before[l] * own[l]);
          }
      range.store(after, ratios);
      return n_held;
    }

  private:
    static constexpr double smallest_share = 1. / 64.;

    static bool
    keeps_volume(const dealii::Tensor<2, dim> &H)
    {
      return dealii::determinant(identity_plus(H)) >= least_det_F;
    }

    const double limit; // [cells]
  };
} // namespace seiche

#endif
