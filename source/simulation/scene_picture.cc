// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/body_force.h>
#include <seiche/scene/scene_map.h>
#include <seiche/simulation/scene_picture.h>
#include <seiche/simulation/scene_section.h>
#include <seiche/simulation/scene_styles.h>
#include <seiche/utilities/svg_canvas.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    using Place = SvgCanvas::Place;

    constexpr double margin = 60., gap = 70., // of panels [px]
      longest_side = 760.,                    // of all panels [px]
      line_height  = 18.;                     // of texts [px]



    /// Lines of a legend below the panels.
    template <int dim>
    void
    draw_legend(const Scene<dim>                  &scene,
                const std::vector<FluidBody<dim>> &bodies,
                Place                              place,
                SvgCanvas                         &canvas)
    {
      const auto sample = [&](const std::string &style,
                              const std::string &text) {
        canvas.line(place, {{place[0] + 30., place[1]}}, style);
        canvas.text({{place[0] + 38., place[1] + 4.}}, text);
        place[0] += 60. + 7. * static_cast<double>(text.size());
      };
      std::set<std::string> shown;
      for (unsigned int side = 0; side < 2 * dim; ++side)
        {
          const LineStyle style = wall_style(scene.grid, side);
          if (shown.insert(style.name).second)
            sample(style.style, style.name);
        }
      const auto fluids = fluid_styles(scene, bodies);
      if (fluids.size() > 1)
        for (const auto &[material, style] : fluids)
          sample("stroke-width:10;stroke:" + style.colour, style.name);
    }



    template <int dim>
    Point<dim>
    centre_of_fluid(const GridParameters<dim>         &grid,
                    const std::vector<FluidBody<dim>> &bodies)
    {
      constexpr unsigned int pieces = 32; // in each direction
      Tensor<1, dim>         moment;
      double                 volume = 0.;
      SceneMap<dim>(grid, bodies, pieces).for_each([&](const auto &piece) {
        if (piece.content < 0)
          return;
        moment += piece.volume * (piece.centre - Point<dim>());
        volume += piece.volume;
      });
      return volume > 0. ? Point<dim>(moment / volume) :
                           bodies.front().shape->bounding_box().center();
    }



    /// The body force at the start in words.
    template <int dim>
    std::string
    force_text(const Scene<dim> &scene, const Point<dim> &place)
    {
      const TankMotion<dim> tank = scene.make_tank_motion();
      const BodyForce<dim>  force(scene.body_force, tank, scene.input);
      const Tensor<1, dim>  b      = force.value(place, /*t=*/0.);
      std::string           result = "body force";
      for (unsigned int d = 0; d < dim; ++d)
        result += fmt::format("{} {:.4g}", d == 0 ? "" : ";", b[d]);
      return result + " m/s^2";
    }
  } // namespace



  template <int dim>
  std::string
  scene_picture(const Scene<dim>                  &scene,
                const std::vector<FluidBody<dim>> &bodies,
                const std::string                 &title)
  {
    const BoundingBox<dim> domain = scene.grid.domain();
    const Point<dim>       middle = centre_of_fluid(scene.grid, bodies);

    // as in a drawing: from the front, beside it from the right, below from
    // above
    const double up        = domain.side_length(dim - 1);
    const double depth     = dim == 3 ? domain.side_length(1) : 0.;
    const double panel_gap = dim == 3 ? gap : 0.;
    const double scale     = (longest_side - panel_gap) /
                         std::max(domain.side_length(0) + depth, up + depth);
    const double width = 2. * margin + panel_gap +
                         scale * (domain.side_length(0) + depth),
                 top    = margin + line_height,
                 panels = panel_gap + scale * (up + depth),
                 height = top + panels + margin + 2. * line_height;
    SvgCanvas canvas(std::max(width, 8. * static_cast<double>(title.size())),
                     height);
    canvas.text({{margin / 2., line_height}}, title);
    canvas.text({{margin / 2., 2. * line_height}}, force_text(scene, middle));

    const auto panel =
      [&](const unsigned int a, const unsigned int b, const Place &corner) {
        draw_section(scene,
                     bodies,
                     SectionView<dim>{a, b, middle, corner, scale},
                     canvas);
      };
    panel(0, dim - 1, {{margin, top}});
    if constexpr (dim == 3)
      {
        panel(1, 2, {{margin + gap + scale * domain.side_length(0), top}});
        panel(0, 1, {{margin, top + gap + scale * up}});
      }
    draw_legend(scene, bodies, {{margin, height - line_height}}, canvas);
    return canvas.str();
  }



  template std::string
  scene_picture(const Scene<2> &,
                const std::vector<FluidBody<2>> &,
                const std::string &);
  template std::string
  scene_picture(const Scene<3> &,
                const std::vector<FluidBody<3>> &,
                const std::string &);
} // namespace seiche
