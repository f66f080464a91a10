// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_wall_impulse_h
#define seiche_grid_wall_impulse_h

#include <seiche/grid/row_mass.h>

namespace seiche
{
  /// Impulse over dt [N] that takes an own, fixed component (dim*node +
  /// component) from v_n to v_0: what a wall does to fluid that arrives, beside
  /// the reaction of the projection (doc/theory.md (8.0b)).
  template <int dim>
  double
  wall_impulse(const GridState<dim> &state,
               const RowMass<dim>   &row_mass,
               const unsigned int    component)
  {
    return row_mass.value(state, component / dim) *
           (state.velocity_start.local_element(component) -
            state.velocity_n.local_element(component)) /
           state.dt;
  }
} // namespace seiche

#endif
