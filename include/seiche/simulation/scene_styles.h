// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_styles_h
#define seiche_simulation_scene_styles_h

#include <seiche/simulation/scene.h>

#include <map>
#include <string>
#include <vector>

namespace seiche
{
  struct LineStyle
  {
    std::string name, style;
  };

  /// How the side of the box is drawn: by its condition, or as a moving one.
  template <int dim>
  LineStyle
  wall_style(const GridParameters<dim> &grid, const unsigned int side);

  struct FluidStyle
  {
    std::string name, colour;
  };

  /// How pictures show the materials that bodies have, by their numbers. The
  /// Fluid has no name of its own: it has that of its body, if that is the only
  /// one. As in contrib/seiche_output.py.
  template <int dim>
  std::map<unsigned int, FluidStyle>
  fluid_styles(const Scene<dim>                  &scene,
               const std::vector<FluidBody<dim>> &bodies);
} // namespace seiche

#endif
