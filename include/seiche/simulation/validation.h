// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_validation_h
#define seiche_simulation_validation_h

#include <seiche/scene/fluid_body.h>
#include <seiche/simulation/scene.h>
#include <seiche/simulation/scene_plan.h>

#include <string>
#include <vector>

namespace seiche
{
  /// What --validate answers of a checked scene: print what a run would need,
  /// warn of what is doubtful, draw the scene into @p output + ".svg" (a
  /// warning if that fails). No grid, no points. Local.
  template <int dim>
  void
  validate(const Scene<dim>                  &scene,
           const std::vector<FluidBody<dim>> &bodies,
           const ScenePlan<dim>              &plan,
           const std::string                 &output);
} // namespace seiche

#endif
