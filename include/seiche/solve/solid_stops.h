// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_solid_stops_h
#define seiche_solve_solid_stops_h

#include <seiche/space/occupancy.h>

namespace seiche
{
  /// A place of a solid's wall that is near to something else, one of them
  /// free.
  template <int dim>
  struct SolidNearby
  {
    unsigned int           solid;
    unsigned int           other;  ///< solid; invalid: a wall of the grid
    dealii::Point<dim>     place;  ///< [m]
    dealii::Tensor<1, dim> normal; ///< away from the other
  };

  /**
   * @brief Where free solids are nearer to others, or to walls of the grid,
   * than they may come (Solid::stop_distance): in the order of places, the same
   * on all ranks. @p time of the walls [s]. Collective.
   */
  template <int dim>
  std::vector<SolidNearby<dim>>
  solids_nearby(const Occupancy<dim> &occupancy, const double time);
} // namespace seiche

#endif
