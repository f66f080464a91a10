// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_conditions.h>

namespace seiche
{
  template <int dim>
  WallConditions<dim>::WallConditions(
    const WallVelocity<dim> &velocity_of_walls,
    const WallMotion<dim>   &motion_of_sides,
    const Occupancy<dim>    &grid_occupancy)
    : wall_velocity(velocity_of_walls)
    , wall_motion(motion_of_sides)
    , occupancy(grid_occupancy)
    , moving(velocity_of_walls.any() || motion_of_sides.any())
  {}

  template <int dim>
  double
  WallConditions<dim>::component(const unsigned int node,
                                 const unsigned int component,
                                 const double       time) const
  {
    double slowest = std::numeric_limits<double>::infinity();
    for (const auto &[wall, c, sides, cell, is_normal] :
         occupancy.constraints.walls_at(node))
      if (c == component)
        {
          const double v =
            wall_velocity.value(wall, occupancy.node_position(node), time)[c];
          if (std::abs(v) < std::abs(slowest))
            slowest = v;
        }
    return slowest;
  }

  template <int dim>
  unsigned int
  WallConditions<dim>::side(const unsigned int node,
                            const unsigned int component) const
  {
    for (const auto &[wall, c, sides, cell, is_normal] :
         occupancy.constraints.walls_at(node))
      if (c == component && occupancy.locator.grid.wall(wall).is_side() &&
          occupancy.locator.grid.wall(wall).side().direction() == component)
        return wall;
    return dealii::numbers::invalid_unsigned_int;
  }

  template <int dim>
  double
  WallConditions<dim>::velocity(const WallDirection<dim> &direction,
                                const double              time,
                                const double              dt) const
  {
    if (!moving)
      return 0.;
    return direction.project([&](const unsigned int c) {
      const unsigned int decides = side(direction.node, c);
      return decides == dealii::numbers::invalid_unsigned_int ?
               component(direction.node, c, time) :
               wall_motion.velocity(decides, time, dt);
    });
  }

  template <int dim>
  double
  WallConditions<dim>::displacement(
    const WallDirection<dim>              &direction,
    const GridState<dim>                  &state,
    const StepCoefficients                &coefficients,
    const typename GridState<dim>::Vector &rate_offset) const
  {
    // a moving side has no oblique directions
    const double       end     = state.time + state.dt;
    const unsigned int decides = moving && direction.component < dim ?
                                   side(direction.node, direction.component) :
                                   dealii::numbers::invalid_unsigned_int;
    const double       theta   = coefficients.theta;
    const double       v0      = direction.of(state.velocity_start);
    // the grid line's own way: no point may be left behind a piston
    if (decides != dealii::numbers::invalid_unsigned_int &&
        wall_motion.moves(decides))
      return wall_motion.displacement(decides, end) -
             wall_motion.displacement(decides, state.time) +
             (1. - theta) / coefficients.rate *
               (v0 - velocity(direction, state.time, state.dt));
    const double v1 = velocity(direction, end, state.dt);
    return (theta * v1 + (1. - theta) * v0 - direction.of(rate_offset)) /
           coefficients.rate;
  }

  template <int dim>
  void
  WallConditions<dim>::set_start_velocity(GridState<dim> &state) const
  {
    state.velocity_start = state.velocity_n;
    occupancy.constraints.for_each_fixed([&](const auto &direction) {
      direction.set(state.velocity_start,
                    velocity(direction, state.time, state.dt));
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
    occupancy.constraints.for_each_fixed([&](const auto &direction) {
      direction.set(state.displacement(),
                    displacement(direction, state, coefficients, rate_offset));
    });
    state.solution.update_ghost_values();
  }

  template class WallConditions<2>;
  template class WallConditions<3>;
} // namespace seiche
