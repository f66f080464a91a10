// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_unseen_momentum_h
#define seiche_transfer_unseen_momentum_h

#include <seiche/grid/grid_state.h>
#include <seiche/points/point_cloud.h>
#include <seiche/transfer/point_velocity.h>

namespace seiche
{
  /**
   * Points of cells in which a component of a node is zero (doc/theory.md
   * (8.0c)) do not count for that component: take their momentum out of the
   * sums in state.velocity_n [kg m/s], and keep it in state.unseen_velocity,
   * their masses in state.unseen_mass; and their accelerations of those in
   * state.acceleration_n. state.mass has all points. @p is_consistent: weights
   * are the shape functions, as in the mass matrix, not the positive hats.
   * Collective.
   */
  template <int dim>
  void
  take_out_unseen(const PointCloud<dim> &points,
                  const Occupancy<dim>  &occupancy,
                  const GradientUse      gradient,
                  const bool             is_consistent,
                  const bool             linear_cells_only,
                  GridState<dim>        &state);

  /// Means in place of the sums in state.unseen_velocity. Collective.
  template <int dim>
  void
  find_unseen_velocity(GridState<dim> &state);
} // namespace seiche

#endif
