// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_speed_of_fall_h
#define seiche_scene_speed_of_fall_h

#include <seiche/scene/body_force.h>
#include <seiche/scene/scene_map.h>

namespace seiche
{
  /// Speed of the fluid if it had all the potential energy that it loses on
  /// its way to the lowest places of the domain: sqrt(g (H - H')) of a column
  /// that becomes a pool [m/s]. Air where the force is no number is no way.
  template <int dim>
  double
  speed_of_fall(const BodyForce<dim> &force, const SceneMap<dim> &map);
} // namespace seiche

#endif
