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
    /// Wet share of a hat that tells nothing: the slope does.
    constexpr double negligible = 1e-4;

    /// Of levels [cells] and of fluid over the hat's integral.
    constexpr double tolerance = 1e-6;
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
                              hat_integrals<dim>(phi, part.wall)[part.vertex]);
      }
    return std::abs(result) < tolerance * hat ? 0. : result;
  }

  template <int dim>
  double
  FluidBelowPlane<dim>::level(const Tensor<1, dim> &gradient,
                              const double          most) const
  {
    const auto missing_at = [&](const double level) {
      return missing(gradient, level);
    };
    const auto is_close = [](const double lower, const double upper) {
      return upper - lower < tolerance;
    };
    double upper = most, lower = std::max(-1., most - 1.);
    if (hat < negligible * cells)
      return lower;
    const double at_upper = missing_at(upper);
    if (at_upper >= 0.)
      return most;
    double at_lower = missing_at(lower);
    if (at_lower < 0. && lower > -1.)
      {
        lower    = -1.;
        at_lower = missing_at(lower);
      }
    if (at_lower <= 0.)
      return lower;
    std::uintmax_t trials  = 30;
    std::tie(lower, upper) = boost::math::tools::toms748_solve(
      missing_at, lower, upper, at_lower, at_upper, is_close, trials);
    return 0.5 * (lower + upper);
  }

  template class FluidBelowPlane<2>;
  template class FluidBelowPlane<3>;
} // namespace seiche
