// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/level_nearby.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Levels beyond say nothing: fills of disordered points are off by 2 %.
    constexpr double near_end = 0.8;

    constexpr double round_off = 1e-9;

    /// A linear function.
    template <int dim>
    struct Plane
    {
      double         mean = 0.;
      Tensor<1, dim> centre, slope;
      Tensor<1, dim> untold; ///< to the node, of what no levels tell

      double
      value(const Tensor<1, dim> &way) const
      {
        return mean + slope * (way - centre);
      }
    };

    /// That which is nearest to those levels that count, at least one: constant
    /// in directions in which they do not differ.
    template <int dim>
    Plane<dim>
    fit(const std::vector<LevelNearby<dim>> &nearby)
    {
      constexpr double apart = 1e-3; // mean square of ways that do differ
      Plane<dim>       result;
      double           n = 0.;
      for (const LevelNearby<dim> &one : nearby)
        if (one.counts)
          {
            n += 1.;
            result.mean += one.level;
            result.centre += one.way;
          }
      result.mean /= n;
      result.centre /= n;
      SymmetricTensor<2, dim> square;
      Tensor<1, dim>          product;
      for (const LevelNearby<dim> &one : nearby)
        if (one.counts)
          {
            const Tensor<1, dim> way = one.way - result.centre;
            square += symmetrize(outer_product(way, way));
            product += (one.level - result.mean) * way;
          }
      for (const auto &[value, direction] : eigenvectors(square))
        if (value > apart * n)
          result.slope += (direction * product) / value * direction;
        else
          result.untold -= (direction * result.centre) * direction;
      return result;
    }
  } // namespace

  template <int dim>
  double
  level_from(std::vector<LevelNearby<dim>> &nearby,
             const std::function<double(const Tensor<1, dim> &, const double)>
               &of_own_fluid)
  {
    constexpr unsigned int most_rounds  = 10;
    constexpr double       least_slope  = 0.1; // less: there is none
    constexpr double       likely_slope = 0.5; // less: hardly a distance
    const auto             is_known     = [](const LevelNearby<dim> &one) {
      return std::abs(one.level) < near_end;
    };
    for (LevelNearby<dim> &one : nearby)
      one.counts = true;
    const Plane<dim> all     = fit(nearby);
    const auto       at_node = [&](const Plane<dim> &plane) {
      const double value  = plane.value(Tensor<1, dim>());
      const double untold = all.untold.norm();
      if (!(value > 0. && untold > 0. && all.slope.norm() < likely_slope))
        return value;
      // perhaps a film: down the way that no levels tell
      return of_own_fluid(all.slope - std::sqrt(1. - all.slope.norm_square()) /
                                        untold * all.untold,
                          value);
    };
    if (std::none_of(nearby.begin(), nearby.end(), is_known))
      return at_node(all);
    for (LevelNearby<dim> &one : nearby)
      one.counts = is_known(one);
    Plane<dim> result;
    bool       changed = true;
    for (unsigned int round = 0; changed && round < most_rounds; ++round)
      {
        result = fit(nearby);
        if (result.slope.norm() < likely_slope)
          result.slope = all.slope;
        if (const double slope = result.slope.norm(); slope > least_slope)
          result.slope /= slope;
        changed = false;
        for (LevelNearby<dim> &one : nearby)
          if (!is_known(one))
            {
              const double least = std::copysign(near_end, one.level);
              const bool   counts =
                (least - result.value(one.way)) * one.level > round_off;
              changed    = changed || counts != one.counts;
              one.counts = counts;
            }
      }
    return at_node(result);
  }

  template double
  level_from<2>(
    std::vector<LevelNearby<2>> &,
    const std::function<double(const Tensor<1, 2> &, const double)> &);
  template double
  level_from<3>(
    std::vector<LevelNearby<3>> &,
    const std::function<double(const Tensor<1, 3> &, const double)> &);
} // namespace seiche
