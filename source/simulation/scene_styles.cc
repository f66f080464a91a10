// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/wall_condition_table.h>
#include <seiche/simulation/scene_styles.h>

#include <array>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr std::array<const char *, 6> colours = {
      {"#6aaee0", "#e3a53b", "#5fa777", "#a272b5", "#cc6a52", "#8a8a5c"}};

    const LineStyle moving_wall = {"moving wall",
                                   "stroke:#e08020;stroke-width:5"};
  } // namespace



  template <int dim>
  LineStyle
  wall_style(const GridParameters<dim> &grid, const unsigned int side)
  {
    if (grid.walls[side].is_displaced())
      return moving_wall;
    for (const WallConditionEntry &entry : wall_condition_table)
      if (entry.condition == grid.walls[side].condition)
        return {entry.name, entry.line};
    Assert(false, ExcInternalError());
    return {};
  }



  template <int dim>
  std::map<unsigned int, FluidStyle>
  fluid_styles(const Scene<dim>                  &scene,
               const std::vector<FluidBody<dim>> &bodies)
  {
    const std::vector<std::string>     further = scene.material_names();
    std::map<unsigned int, FluidStyle> styles;
    for (const auto &body : bodies)
      {
        const auto [style, is_first] = styles.insert({body.material, {}});
        style->second.name = body.material > 0 ? further[body.material - 1] :
                             is_first          ? body.name :
                                                 "fluid";
      }
    unsigned int n = 0;
    for (auto &[material, style] : styles)
      style.colour = colours[n++ % colours.size()];
    return styles;
  }



  template LineStyle
  wall_style(const GridParameters<2> &, const unsigned int);
  template LineStyle
  wall_style(const GridParameters<3> &, const unsigned int);
  template std::map<unsigned int, FluidStyle>
  fluid_styles(const Scene<2> &, const std::vector<FluidBody<2>> &);
  template std::map<unsigned int, FluidStyle>
  fluid_styles(const Scene<3> &, const std::vector<FluidBody<3>> &);
} // namespace seiche
