// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_segments.h>
#include <seiche/simulation/scene_section.h>
#include <seiche/simulation/scene_styles.h>
#include <seiche/utilities/svg_labels.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    using Place = SvgCanvas::Place;

    constexpr double fluid_samples = 240.; // along the longer side

    constexpr const char *obstacle_style = "fill:#9a9a9a;stroke:#444",
                         *solid_style    = "fill:#9a9a9a;stroke:none",
                         *grid_style     = "stroke:#d4d4d4;stroke-width:0.5",
                         *refined_style  = "fill:none;stroke:#8a5fbf;"
                                           "stroke-dasharray:4 3",
                         *place_style    = "fill:#d03030;stroke:white",
                         *tick_style     = "stroke:#222";



    /// A place that is a round number, for an axis with about @p n of them.
    double
    round_step(const double length, const unsigned int n)
    {
      const double step  = length / n;
      const double power = std::pow(10., std::floor(std::log10(step)));
      for (const double factor : {1., 2., 5.})
        if (factor * power >= step)
          return factor * power;
      return 10. * power;
    }



    /// The part of a square where a function, given at its corners in order,
    /// is negative; linear along the edges.
    std::vector<Place>
    negative_part(const std::array<Place, 4>  &corners,
                  const std::array<double, 4> &values)
    {
      std::vector<Place> result;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const unsigned int j = (i + 1) % 4;
          if (values[i] < 0.)
            result.push_back(corners[i]);
          if ((values[i] < 0.) != (values[j] < 0.))
            {
              const double t = values[i] / (values[i] - values[j]);
              result.push_back(
                {{corners[i][0] + t * (corners[j][0] - corners[i][0]),
                  corners[i][1] + t * (corners[j][1] - corners[i][1])}});
            }
        }
      return result;
    }



    /// A section of the scene: two directions of space on the paper.
    template <int dim>
    class Section
    {
    public:
      Section(const Scene<dim>                  &scene_parameters,
              const std::vector<FluidBody<dim>> &fluid_bodies,
              const SectionView<dim>            &view,
              SvgCanvas                         &svg_canvas)
        : scene(scene_parameters)
        , grid(scene_parameters.grid)
        , bodies(fluid_bodies)
        , styles(fluid_styles(scene_parameters, fluid_bodies))
        , across(view.across)
        , up(view.up)
        , middle(view.middle)
        , upper_left(view.upper_left)
        , scale(view.scale)
        , canvas(svg_canvas)
        , labels(svg_canvas)
      {}

      void
      draw()
      {
        draw_fluids();
        draw_solids();
        draw_grid();
        draw_walls();
        draw_axes(); // its texts are always there
        draw_obstacles();
        draw_refined_boxes();
        draw_places();
      }

    private:
      using Range = std::pair<unsigned int, unsigned int>; // of bodies

      Place
      place(const double a, const double b) const
      {
        return {{upper_left[0] + scale * (a - grid.lower_corner[across]),
                 upper_left[1] + scale * (grid.upper_corner[up] - b)}};
      }

      Place
      place(const Point<dim> &x) const
      {
        return place(x[across], x[up]);
      }

      double
      level(const Point<dim> &x, const Range &group) const
      {
        double lowest = std::numeric_limits<double>::max();
        for (unsigned int body = group.first; body < group.second; ++body)
          lowest = std::min(lowest, bodies[body].shape->level(x));
        return lowest;
      }

      /// Bodies that follow each other and have one material at once; the
      /// first ones last, which have what several bodies cover.
      void
      draw_fluids()
      {
        const auto material = [&](const unsigned int body) {
          return bodies[body].material;
        };
        for (unsigned int end = bodies.size(), begin; end > 0; end = begin)
          {
            begin = end - 1;
            while (begin > 0 && material(begin - 1) == material(begin))
              --begin;
            draw_area(
              [&](const Point<dim> &x) {
                return level(x, {begin, end});
              },
              "fill:" + styles.at(material(begin)).colour + ";stroke:none");
          }
      }

      void
      draw_solids()
      {
        if (!grid.solids.empty())
          draw_area(
            [&](const Point<dim> &x) { return distance_from(grid.solids, x); },
            solid_style);
      }

      /// Where a function of the place is negative.
      void
      draw_area(const std::function<double(const Point<dim> &)> &function,
                const std::string                               &style)
      {
        const auto at = [&](const double a_x, const double b_x) {
          Point<dim> x = middle;
          x[across]    = a_x;
          x[up]        = b_x;
          return function(x);
        };
        const double width   = grid.domain().side_length(across),
                     height  = grid.domain().side_length(up),
                     wanted  = std::max(width, height) / fluid_samples;
        const unsigned int n = std::ceil(width / wanted),
                           m = std::ceil(height / wanted);
        const auto a         = [&](const unsigned int i) {
          return grid.lower_corner[across] + width * i / n;
        };
        const auto b = [&](const unsigned int j) {
          return grid.lower_corner[up] + height * j / m;
        };
        // a little inside, so that a body's face on a wall is fluid
        std::vector<double> values((n + 1) * (m + 1));
        const double        inside = 1e-6 * wanted;
        for (unsigned int j = 0; j <= m; ++j)
          for (unsigned int i = 0; i <= n; ++i)
            values[j * (n + 1) + i] = at(a(i) + (i == 0 ? inside :
                                                 i == n ? -inside :
                                                          0.),
                                         b(j) + (j == 0 ? inside :
                                                 j == m ? -inside :
                                                          0.));
        std::vector<std::vector<Place>> parts;
        for (unsigned int j = 0; j < m; ++j)
          for (unsigned int i = 0; i < n; ++i)
            {
              const auto value = [&](const unsigned int right,
                                     const unsigned int above) {
                return values[(j + above) * (n + 1) + i + right];
              };
              // squares full of fluid that follow each other are one
              const unsigned int first = i;
              while (i + 1 < n && value(0, 0) < 0. && value(0, 1) < 0. &&
                     value(1, 0) < 0. && value(1, 1) < 0. && value(2, 0) < 0. &&
                     value(2, 1) < 0.)
                ++i;
              auto part = negative_part(
                {{place(a(first), b(j)),
                  place(a(i + 1), b(j)),
                  place(a(i + 1), b(j + 1)),
                  place(a(first), b(j + 1))}},
                {{value(0, 0), value(1, 0), value(1, 1), value(0, 1)}});
              if (part.size() > 2)
                parts.push_back(std::move(part));
            }
        canvas.polygons(parts, style);
      }

      void
      draw_grid()
      {
        for (const unsigned int d : {across, up})
          for (const GridSegment &segment : make_segments(grid, d))
            {
              const double       length  = segment.end - segment.begin;
              const double       fitting = scale * length / 4.; // lines
              const unsigned int stride =
                std::max(1., std::ceil(segment.cells / std::max(1., fitting)));
              for (unsigned int i = 0; i < segment.cells; i += stride)
                {
                  const double x = segment.begin + length * i / segment.cells;
                  if (d == across)
                    canvas.line(place(x, grid.lower_corner[up]),
                                place(x, grid.upper_corner[up]),
                                grid_style);
                  else
                    canvas.line(place(grid.lower_corner[across], x),
                                place(grid.upper_corner[across], x),
                                grid_style);
                }
            }
      }

      void
      draw_box(const BoundingBox<dim> &box,
               const std::string      &name,
               const std::string      &style)
      {
        for (unsigned int d = 0; d < dim; ++d)
          if (d != across && d != up &&
              (middle[d] < box.lower_bound(d) ||
               middle[d] > box.upper_bound(d)))
            return;
        const Place from = place(box.lower_bound(across), box.upper_bound(up)),
                    to   = place(box.upper_bound(across), box.lower_bound(up));
        canvas.rectangle(from, to, style);
        const double centre = 0.5 * (from[0] + to[0]);
        labels.write_where_free({{{{centre, 0.5 * (from[1] + to[1]) + 4.}},
                                  "middle"},
                                 {{{centre, from[1] - 4.}}, "middle"},
                                 {{{centre, to[1] + 12.}}, "middle"}},
                                name);
      }

      void
      draw_obstacles()
      {
        for (const auto &obstacle : grid.obstacles())
          draw_box(obstacle.box(), obstacle.name, obstacle_style);
      }

      void
      draw_refined_boxes()
      {
        for (const auto &criterion : grid.refinement.criteria)
          if (criterion.kind == RefinementKind::box)
            for (const auto &box : criterion.places)
              draw_box(box, criterion.name, refined_style);
      }

      void
      draw_walls()
      {
        const Place low  = place(grid.lower_corner),
                    high = place(grid.upper_corner);
        const std::array<std::pair<Place, Place>, 4> sides = {
          {{low, {{low[0], high[1]}}},
           {{{high[0], low[1]}}, high},
           {low, {{high[0], low[1]}}},
           {{{low[0], high[1]}}, high}}};
        for (unsigned int i = 0; i < 4; ++i)
          {
            const unsigned int side = 2 * (i < 2 ? across : up) + i % 2;
            canvas.line(sides[i].first,
                        sides[i].second,
                        wall_style(grid, side).style);
          }
      }

      void
      draw_axes()
      {
        for (const unsigned int d : {across, up})
          {
            const bool   is_across = d == across;
            const double lower     = grid.lower_corner[d],
                         upper     = grid.upper_corner[d];
            const unsigned int fitting =
              std::clamp(std::ceil(scale * (upper - lower) / 60.), 2., 8.);
            const double step = round_step(upper - lower, fitting);
            for (double x = step * std::ceil(lower / step - 1e-9);
                 x <= upper + 1e-9 * step;
                 x += step)
              {
                const Place begin = is_across ?
                                      place(x, grid.lower_corner[up]) :
                                      place(grid.lower_corner[across], x);
                const Place end = is_across ? Place{{begin[0], begin[1] + 6.}} :
                                              Place{{begin[0] - 6., begin[1]}};
                canvas.line(begin, end, tick_style);
                labels.write(
                  is_across ?
                    SvgLabels::At{{{end[0], end[1] + 13.}}, "middle"} :
                    SvgLabels::At{{{end[0] - 4., end[1] + 4.}}, "end"},
                  fmt::format("{:.4g}", std::abs(x) < 1e-9 * step ? 0. : x));
              }
            const std::string name = fmt::format("{} [m]", "xyz"[d]);
            if (is_across)
              canvas.text({{0.5 * (place(lower, 0.)[0] + place(upper, 0.)[0]),
                            place(grid.lower_corner)[1] + 34.}},
                          name,
                          "middle");
            else
              canvas.text({{place(grid.lower_corner)[0] - 10.,
                            place(grid.upper_corner)[1] - 10.}},
                          name,
                          "middle");
          }
      }

      void
      draw_places()
      {
        for (const auto &measured : scene.postprocessors.places())
          {
            const Place centre = place(measured.place);
            canvas.circle(centre, 4., place_style);
            std::vector<SvgLabels::At> around;
            for (const double down : {-5., 14.})
              for (const char *anchor : {"start", "end"})
                around.push_back({{{centre[0] + (anchor[0] == 's' ? 6. : -6.),
                                    centre[1] + down}},
                                  anchor});
            labels.write_where_free(around, measured.name);
          }
      }

      const Scene<dim>                        &scene;
      const GridParameters<dim>               &grid;
      const std::vector<FluidBody<dim>>       &bodies;
      const std::map<unsigned int, FluidStyle> styles; // by material
      const unsigned int                       across, up;
      const Point<dim>                         middle;
      const Place                              upper_left;
      const double                             scale;
      SvgCanvas                               &canvas;
      SvgLabels                                labels;
    };
  } // namespace



  template <int dim>
  void
  draw_section(const Scene<dim>                  &scene,
               const std::vector<FluidBody<dim>> &bodies,
               const SectionView<dim>            &view,
               SvgCanvas                         &canvas)
  {
    Section<dim>(scene, bodies, view, canvas).draw();
  }



  template void
  draw_section(const Scene<2> &,
               const std::vector<FluidBody<2>> &,
               const SectionView<2> &,
               SvgCanvas &);
  template void
  draw_section(const Scene<3> &,
               const std::vector<FluidBody<3>> &,
               const SectionView<3> &,
               SvgCanvas &);
} // namespace seiche
