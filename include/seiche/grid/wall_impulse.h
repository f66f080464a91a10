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
    return row_mass.seen(state, direction) *
           (direction.of(state.velocity_start) -
            direction.of(state.velocity_n)) /
           state.dt;
  }

  /// Add the impulses over dt [N] of the walls on all fluid that arrives to
  /// state.start_reaction, which has those of the projection: on nodes that
  /// are fixed, and on the points that bring their velocity to a face alone
  /// (8.0c). Own nodes.
  template <int dim>
  void
  add_wall_impulses(const RowMass<dim>   &row_mass,
                    const Occupancy<dim> &occupancy,
                    GridState<dim>       &state)
  {
    for (unsigned int i = 0; i < state.unseen_mass.locally_owned_size(); ++i)
      state.start_reaction.local_element(i) -=
        state.unseen_mass.local_element(i) *
        state.unseen_velocity.local_element(i) / state.dt;
    occupancy.constraints.for_each_fixed([&](const auto &direction) {
      direction.set(state.start_reaction,
                    direction.of(state.start_reaction) +
                      wall_impulse(state, row_mass, direction));
    });
  }
} // namespace seiche

#endif
