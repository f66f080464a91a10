// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_step_advice_h
#define seiche_simulation_step_advice_h

#include <seiche/simulation/scene.h>
#include <seiche/simulation/scene_scales.h>

#include <string>

namespace seiche
{
  /// What may help where a step fails at every size: the entries of this scene
  /// that are not at what stands violent flow (doc/methods.md), most effective
  /// first, each as "Subsection/Entry = value". A sentence; where the step is
  /// so small that only round-off is left, another one.
  template <int dim>
  std::string
  step_advice(const Scene<dim> &scene, const SceneScales &scales);
} // namespace seiche

#endif
