// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_scene_picture_h
#define seiche_simulation_scene_picture_h

#include <seiche/simulation/scene.h>

#include <string>

namespace seiche
{
  /**
   * The scene at its start as SVG: fluid, obstacles, walls by their condition,
   * grid lines, gravity, refined boxes, probes and gauges. In 3D three sections
   * through the middle of the fluid, from the front, from the right and from
   * above. @p title above it. Local.
   */
  template <int dim>
  std::string
  scene_picture(const Scene<dim>                  &scene,
                const std::vector<FluidBody<dim>> &bodies,
                const std::string                 &title);
} // namespace seiche

#endif
