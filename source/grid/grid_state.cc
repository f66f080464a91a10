// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/grid_state.h>

namespace seiche
{
  template <int dim>
  void
  GridState<dim>::reinit(const Occupancy<dim> &occupancy,
                         const bool            with_pressure,
                         const bool            with_acceleration)
  {
    const auto &nodes      = occupancy.nodes.partitioner();
    const auto &components = occupancy.nodes.vector_partitioner();
    mass.reinit(nodes);
    pressure_guess.reinit(nodes);
    for (Vector *vector : {&velocity_n,
                           &velocity_start,
                           &velocity_np1,
                           &acceleration_np1,
                           &reaction,
                           &start_reaction})
      vector->reinit(components);
    for (Vector *vector : {&velocity_series, &unseen_series})
      vector->reinit(0);
    drags.clear();
    solid_reactions.clear();
    solid_start_reactions.clear();
    for (Vector *vector : {&unseen_velocity, &unseen_mass})
      if (occupancy.zero_components.exist())
        vector->reinit(components);
      else
        vector->reinit(0);
    if (with_acceleration)
      acceleration_n.reinit(components);
    solution.reinit(with_pressure ? 2 : 1);
    solution.block(0).reinit(components);
    if (with_pressure)
      solution.block(1).reinit(nodes);
    solution.collect_sizes();
  }

  template struct GridState<2>;
  template struct GridState<3>;
} // namespace seiche
