// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/box_part.h>

#include <deal.II/base/geometry_info.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double missed  = 1e-6;  // share of the first box
    constexpr double on_face = 1e-12; // of an edge
    // deepest division: what a corner or an edge leaves is of the order of
    // 2^(-2 depth) of the box
    template <int dim>
    constexpr unsigned int max_depth = dim == 2 ? 8 : 4;

    using Rule = std::array<std::pair<double, double>, 3>;

    /// Places and weights, symmetric, exact for cubic polynomials.
    Rule
    make_rule(const double to_centre)
    {
      const double share = 1. / (24. * to_centre * to_centre);
      return {{{0.5 - to_centre, share},
               {0.5, 1. - 2. * share},
               {0.5 + to_centre, share}}};
    }

    const Rule gauss = make_rule(std::sqrt(0.15));
    const Rule check = make_rule(0.49); // sees corners near the ends

    /// Volume and first moments in the unit cell of one box.
    template <int dim>
    class Integral
    {
    public:
      Integral(const typename BoxPart<dim>::Level &level_set,
               const BoundingBox<dim>             &whole)
        : level(level_set)
        , box(whole)
      {}

      /// Sorts the directions; false if the box is not near the surface.
      bool
      is_cut();

      void
      evaluate(const Rule &rule);

      double         volume = 0.;
      Tensor<1, dim> first;

    private:
      double
      value(const Point<dim> &unit) const
      {
        return level(box.unit_to_real(unit));
      }

      /// The section through @p unit along the first @p n directions.
      void
      add(Point<dim> &unit, const unsigned int n, const double weight);

      /// Where the function changes sign on the line along @p direction.
      void
      find_roots(Point<dim>           unit,
                 const unsigned int   direction,
                 std::vector<double> &places) const;

      const typename BoxPart<dim>::Level &level;
      const BoundingBox<dim>              box;
      std::array<unsigned int, dim>       order;
      const Rule                         *rule = &gauss;
    };

    template <int dim>
    bool
    Integral<dim>::is_cut()
    {
      // a surface beside the box that bulges into it between its vertices
      constexpr double near = dim == 2 ? 0.5 : 0.25;

      Tensor<1, dim> change;
      Point<dim>     middle;
      for (unsigned int d = 0; d < dim; ++d)
        middle[d] = 0.5;
      const double at_centre = value(middle);
      double       lowest = at_centre, highest = at_centre;
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        {
          const double here = value(GeometryInfo<dim>::unit_cell_vertex(v));
          lowest            = std::min(lowest, here);
          highest           = std::max(highest, here);
          for (unsigned int d = 0; d < dim; ++d)
            change[d] += ((v >> d) & 1u) != 0 ? here : -here;
        }
      for (unsigned int d = 0; d < dim; ++d)
        order[d] = d;
      std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
        return std::abs(change[a]) > std::abs(change[b]);
      });
      const double margin = near * (highest - lowest);
      if (highest < 0. && -highest >= margin)
        {
          volume = 1.;
          first  = middle;
        }
      return lowest < margin && (highest >= 0. || -highest < margin);
    }

    template <int dim>
    void
    Integral<dim>::evaluate(const Rule &chosen_rule)
    {
      rule   = &chosen_rule;
      volume = 0.;
      first  = Tensor<1, dim>();
      Point<dim> unit;
      add(unit, dim, 1.);
    }

    template <int dim>
    void
    Integral<dim>::add(Point<dim>        &unit,
                       const unsigned int n,
                       const double       weight)
    {
      const unsigned int  d = order[n - 1];
      std::vector<double> places{0., 1.};
      for (unsigned int edge = 0; edge < (1u << (n - 1)); ++edge)
        {
          for (unsigned int i = 0; i + 1 < n; ++i)
            unit[order[i]] = (edge >> i) & 1u;
          find_roots(unit, d, places);
        }
      std::sort(places.begin(), places.end());
      for (std::size_t i = 0; i + 1 < places.size(); ++i)
        {
          const double length = places[i + 1] - places[i];
          if (length < on_face)
            continue;
          if (n > 1)
            for (const auto &[place, share] : *rule)
              {
                unit[d] = places[i] + place * length;
                add(unit, n - 1, weight * length * share);
              }
          else
            {
              unit[d] = places[i] + 0.5 * length;
              if (value(unit) >= 0.)
                continue;
              volume += weight * length;
              first += weight * length * (unit - Point<dim>());
            }
        }
    }

    template <int dim>
    void
    Integral<dim>::find_roots(Point<dim>           unit,
                              const unsigned int   direction,
                              std::vector<double> &places) const
    {
      constexpr unsigned int n_parts = dim == 2 ? 8 : 3;
      const auto             at      = [&](const double place) {
        unit[direction] = place;
        return value(unit);
      };
      const auto is_near = [](const double a, const double b) {
        return std::abs(b - a) < on_face;
      };
      double a = 0., at_a = at(a);
      for (unsigned int part = 1; part <= n_parts; ++part)
        {
          const double b    = part / static_cast<double>(n_parts);
          const double at_b = at(b);
          if ((at_a < 0.) != (at_b < 0.))
            {
              std::uintmax_t n_iterations = 60;
              const auto [lower, upper]   = boost::math::tools::toms748_solve(
                at, a, b, at_a, at_b, is_near, n_iterations);
              places.push_back(0.5 * (lower + upper));
            }
          a    = b;
          at_a = at_b;
        }
    }

    /// Adds the part of @p box, the first one halved @p depth times along each
    /// axis.
    template <int dim>
    void
    add_part(const typename BoxPart<dim>::Level &level,
             const BoundingBox<dim>             &box,
             const double                        tolerance,
             const unsigned int                  depth,
             BoxPart<dim>                       &sum)
    {
      const double  size = std::pow(0.5, static_cast<double>(dim * depth));
      Integral<dim> integral(level, box);
      if (integral.is_cut())
        {
          integral.evaluate(check);
          const double checked = integral.volume;
          integral.evaluate(gauss);
          const bool is_missed = depth == 0 && (integral.volume < missed ||
                                                integral.volume > 1. - missed);
          if (is_missed ||
              (std::abs(integral.volume - checked) * size > tolerance &&
               depth < max_depth<dim>))
            {
              for (unsigned int i = 0; i < (1u << dim); ++i)
                add_part(level, box.child(i), tolerance, depth + 1, sum);
              return;
            }
        }
      sum.share += integral.volume * size;
      // the first moment, until all are summed
      if (integral.volume > 0.)
        sum.centre +=
          integral.volume * size *
          (box.unit_to_real(Point<dim>() + integral.first / integral.volume) -
           Point<dim>());
    }
  } // namespace

  template <int dim>
  BoxPart<dim>
  part_inside(const typename BoxPart<dim>::Level &level,
              const BoundingBox<dim>             &box,
              const double                        tolerance)
  {
    constexpr double round_off = 1e-9;

    BoxPart<dim> part;
    add_part(level, box, tolerance, 0, part);
    if (part.share < round_off)
      return {0., box.center()};
    if (part.share > 1. - round_off)
      return {1., box.center()};
    part.centre /= part.share;
    return part;
  }

  template BoxPart<2>
  part_inside<2>(const BoxPart<2>::Level &,
                 const BoundingBox<2> &,
                 const double);
  template BoxPart<3>
  part_inside<3>(const BoxPart<3>::Level &,
                 const BoundingBox<3> &,
                 const double);
} // namespace seiche
