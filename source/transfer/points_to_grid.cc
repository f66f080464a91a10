// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/extrapolation.h>
#include <seiche/transfer/point_sums.h>
#include <seiche/transfer/transfer.h>

namespace seiche
{
  namespace
  {
    /// Sums to means. Own nodes.
    template <int dim>
    void
    divide_by_mass(const Occupancy<dim> &occupancy,
                   const bool            with_acceleration,
                   GridState<dim>       &state)
    {
      double *pressure     = state.pressure_guess.begin();
      double *velocity     = state.velocity_n.begin();
      double *acceleration = state.acceleration_n.begin();
      for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
        {
          const double mass = state.mass.local_element(node);
          pressure[node] *= mass > 0. ? 1. / mass : 0.;
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double seen    = state.seen_mass(node, c);
              const double inverse = seen > 0. ? 1. / seen : 0.;
              velocity[dim * node + c] *= inverse;
              if (with_acceleration)
                acceleration[dim * node + c] *= inverse;
              if (const double unseen = state.unseen(node, c); unseen != 0.)
                state.unseen_velocity.local_element(dim * node + c) /= unseen;
            }
        }
    }
  } // namespace

  template <int dim>
  void
  Transfer<dim>::points_to_grid(const PointCloud<dim> &points,
                                GridState<dim>        &state) const
  {
    const bool with_acceleration =
      state.acceleration_n.size() > 0 && points.has(PointColumn::acceleration);
    const bool is_consistent = parameters.is_consistent(occupancy.fe.degree);
    sum_to_nodes(points,
                 occupancy,
                 method.gradient,
                 is_consistent,
                 /*linear_cells_only=*/false,
                 state);
    divide_by_mass(occupancy, with_acceleration, state);
    state.mass.update_ghost_values();
    state.pressure_guess.update_ghost_values();
    state.velocity_n.update_ghost_values();
    state.unseen_velocity.update_ghost_values();
    if (state.acceleration_n.size() > 0)
      state.acceleration_n.update_ghost_values();
    if (is_consistent)
      find_closest(points, state);
    if (method.update == VelocityUpdate::fmpm ||
        method.update == VelocityUpdate::xpic)
      expand_series(points, state);
    if (fill.has_surface())
      extrapolate_fields(points, fill, state);
  }

  template void
  Transfer<2>::points_to_grid(const PointCloud<2> &, GridState<2> &) const;
  template void
  Transfer<3>::points_to_grid(const PointCloud<3> &, GridState<3> &) const;
} // namespace seiche
