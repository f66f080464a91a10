// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_conditions.h>

namespace seiche
{
  template <int dim>
  WallConditions<dim>::WallConditions(const WallVelocity<dim> &wall_velocity,
                                      const Occupancy<dim>    &grid_occupancy)
    : velocity(wall_velocity)
    , occupancy(grid_occupancy)
    , moving(wall_velocity.any())
  {}

  template <int dim>
  double
  WallConditions<dim>::component(const unsigned int node,
                                 const unsigned int component,
                                 const double       time) const
  {
    double slowest = std::numeric_limits<double>::infinity();
    for (const auto &[wall, c] : occupancy.walls_at(node))
      if (c == component)
        {
          if (wall < 2 * dim && wall / 2 == component)
            return 0.;
          const double v =
            velocity.value(wall, occupancy.node_position(node), time)[c];
          if (std::abs(v) < std::abs(slowest))
            slowest = v;
        }
    return slowest;
  }

  template <int dim>
  void
  WallConditions<dim>::set_start_velocity(GridState<dim> &state) const
  {
    state.velocity_start = state.velocity_n;
    occupancy.for_each_fixed([&](const unsigned int i) {
      state.velocity_start.local_element(i) =
        moving ? component(i / dim, i % dim, state.time) : 0.;
    });
    state.velocity_start.update_ghost_values();
  }

  template <int dim>
  void
  WallConditions<dim>::set_displacement(
    GridState<dim>                        &state,
    const StepCoefficients                &coefficients,
    const typename GridState<dim>::Vector &rate_offset) const
  {
    if (!moving)
      return;
    const double theta = coefficients.theta;
    occupancy.for_each_fixed([&](const unsigned int i) {
      const double v0 = state.velocity_start.local_element(i);
      const double v1 = component(i / dim, i % dim, state.time + state.dt);
      state.displacement().local_element(i) =
        (theta * v1 + (1. - theta) * v0 - rate_offset.local_element(i)) /
        coefficients.rate;
    });
    state.solution.update_ghost_values();
  }

  template class WallConditions<2>;
  template class WallConditions<3>;
} // namespace seiche
