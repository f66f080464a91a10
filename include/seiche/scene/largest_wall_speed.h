// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_largest_wall_speed_h
#define seiche_scene_largest_wall_speed_h

#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/tank_motion.h>

namespace seiche
{
  /**
   * @brief Largest speed that walls impart in a run [m/s]: of no-slip walls
   * along themselves, of sides that move, and of the tank's middle, beside its
   * velocity at the start, which the fluid has, too.
   *
   * From the entries, at sample_times(); no-slip walls in corners and middles,
   * but where their velocity is no number, for an obstacle may cover that.
   * Local.
   */
  template <int dim>
  double
  largest_wall_speed(const GridParameters<dim> &grid,
                     const TankMotion<dim>     &tank,
                     const double               end_time);
} // namespace seiche

#endif
