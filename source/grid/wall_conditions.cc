// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_conditions.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  WallConditions<dim>::WallConditions(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
    , moving(grid_occupancy.locator.grid.parameters.any_moving())
  {}

  template <int dim>
  const Wall<dim> *
  WallConditions<dim>::side(const unsigned int node,
                            const unsigned int component) const
  {
    for (const auto &[number, c, sides, cell, is_normal] :
         occupancy.constraints.walls_at(node))
      {
        const Wall<dim> &wall = occupancy.locator.grid.wall(number);
        if (c == component && wall.is_side() &&
            wall.side().direction() == component)
          return &wall;
      }
    return nullptr;
  }

  template <int dim>
  double
  WallConditions<dim>::component(const unsigned int node,
                                 const unsigned int component,
                                 const double       time,
                                 const double       dt) const
  {
    const Point<dim> &x = occupancy.nodes.position(node);
    if (const Wall<dim> *const decides = side(node, component))
      return decides->velocity(x, time, dt)[component];
    double slowest = std::numeric_limits<double>::infinity();
    for (const auto &[number, c, sides, cell, is_normal] :
         occupancy.constraints.walls_at(node))
      if (c == component)
        {
          // an obstacle stays where it is
          const double v =
            is_normal ?
              0. :
              occupancy.locator.grid.wall(number).sliding_velocity(x, time)[c];
          if (std::abs(v) < std::abs(slowest))
            slowest = v;
        }
    return slowest;
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
      return component(direction.node, c, time, dt);
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
    const double           end = state.time + state.dt;
    const Wall<dim> *const decides =
      moving && direction.component < dim ?
        side(direction.node, direction.component) :
        nullptr;
    const double theta = coefficients.theta;
    const double v0    = direction.of(state.velocity_start);
    // the grid line's own way: no point may be left behind a piston
    if (decides != nullptr && decides->is_displaced())
      return decides->displacement(end) - decides->displacement(state.time) +
             (1. - theta) / coefficients.rate *
               (v0 - velocity(direction, state.time, state.dt));
    const double v1 = velocity(direction, end, state.dt);
    return (theta * v1 + (1. - theta) * v0 - direction.of(rate_offset)) /
           coefficients.rate;
  }

  template <int dim>
  template <typename WayOf>
  void
  WallConditions<dim>::set_solids(GridState<dim> &state,
                                  const WayOf    &way_of) const
  {
    state.solids.clear();
    for (const Solid<dim> &solid : occupancy.locator.solids)
      state.solids.push_back(
        {way_of(solid), solid.friction, solid.slip_length, solid.may_be_left});
  }

  template <int dim>
  void
  WallConditions<dim>::set_ways_of_solids(GridState<dim> &state,
                                          const double    theta) const
  {
    set_solids(state, [&](const Solid<dim> &solid) {
      return solid.way(state.dt, theta);
    });
  }

  template <int dim>
  void
  WallConditions<dim>::set_start_velocity(GridState<dim> &state) const
  {
    set_solids(state, [&](const Solid<dim> &solid) {
      RigidWay<dim> way = solid.velocity();
      way *= state.dt;
      return way;
    });
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
    set_ways_of_solids(state, coefficients.theta);
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
