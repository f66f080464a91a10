// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/fluid_below_plane.h>
#include <seiche/space/wet_part.h>

#include <deal.II/base/geometry_info.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Integral of a hat over the volume of its cells below which it tells
    /// nothing: the slope does.
    constexpr double negligible = 1e-4;

    /// Of levels [cells] and of fluid over the hat's integral.
    constexpr double tolerance = 1e-6;

    /// From the guess to a bracket of the level [cells].
    constexpr double first_step = 0.02, step_growth = 8.;
  } // namespace

  template <int dim>
  void
  FluidBelowPlane<dim>::add_cell(const unsigned int       vertex,
                                 const double             measure,
                                 const double             wet_hat,
                                 const VertexValues<dim> &wall)
  {
    parts.push_back({vertex, measure, wet_hat, wall});
    cells += measure;
    hat += wet_hat * measure;
  }

  template <int dim>
  double
  FluidBelowPlane<dim>::missing(const Tensor<1, dim> &gradient,
                                const double          level) const
  {
    using Shape   = GeometryInfo<dim>;
    double result = -fluid;
    for (const Part &part : parts)
      {
        VertexValues<dim> phi;
        for (const unsigned int v : Shape::vertex_indices())
          phi[v] = gradient * (Shape::unit_cell_vertex(v) -
                               Shape::unit_cell_vertex(part.vertex)) +
                   level;
        const auto [lowest, highest] =
          std::minmax_element(phi.begin(), phi.end());
        if (*lowest < 0.)
          result +=
            part.measure * (*highest < 0. ?
                              part.wet_hat :
                              hat_integral<dim>(part.vertex, phi, part.wall));
      }
    return std::abs(result) < tolerance * hat ? 0. : result;
  }

  template <int dim>
  double
  FluidBelowPlane<dim>::level(const Tensor<1, dim> &gradient,
                              const double          most,
                              const double          guess) const
  {
    if (hat < negligible * cells || fluid > (1. - tolerance) * hat)
      return std::max(-1., most - 1.);
    if (fluid < tolerance * hat)
      return most;
    const auto missing_at = [&](const double level) {
      return missing(gradient, level);
    };
    double upper    = std::clamp(guess, -1., most);
    double at_upper = missing_at(upper);
    double lower = upper, at_lower = at_upper;
    for (double step = first_step; at_lower < 0. && lower > -1.;
         step *= step_growth)
      {
        upper    = lower;
        at_upper = at_lower;
        lower    = std::max(-1., lower - step);
        at_lower = missing_at(lower);
      }
    for (double step = first_step; at_upper > 0. && upper < most;
         step *= step_growth)
      {
        lower    = upper;
        at_lower = at_upper;
        upper    = std::min(most, upper + step);
        at_upper = missing_at(upper);
      }
    if (at_lower <= 0.)
      return lower;
    if (at_upper >= 0.)
      return upper;
    const auto is_close = [](const double a, const double b) {
      return b - a < tolerance;
    };
    std::uintmax_t trials  = 30;
    std::tie(lower, upper) = boost::math::tools::toms748_solve(
      missing_at, lower, upper, at_lower, at_upper, is_close, trials);
    return 0.5 * (lower + upper);
  }

  template class FluidBelowPlane<2>;
  template class FluidBelowPlane<3>;
} // namespace seiche
