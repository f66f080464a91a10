// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_wall_impulse_h
#define seiche_grid_wall_impulse_h

#include <seiche/grid/row_mass.h>

namespace seiche
{
  /// Impulse over dt [N] that takes an own node from v_n to v_0 in a direction
  /// in which walls fix it: what they do to fluid that arrives, beside
  /// the reaction of the projection (doc/theory.md (8.0b)).
  template <int dim>
  double
  wall_impulse(const GridState<dim>     &state,
               const RowMass<dim>       &row_mass,
               const WallDirection<dim> &direction)
  {
    return row_mass.value(state, direction.node) *
           (direction.of(state.velocity_start) -
            direction.of(state.velocity_n)) /
           state.dt;
  }
} // namespace seiche

#endif
