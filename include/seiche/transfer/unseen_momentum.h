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
   * (8.0c)) do not count for that component: add their momentum to
   * state.unseen_velocity [kg m/s] and their masses to state.unseen_mass, and
   * take their accelerations out of the sums in state.acceleration_n. @p
   * is_consistent: weights are the shape functions, as in the mass matrix, not
   * the positive hats. Own and ghost entries, to be compressed.
   */
  template <int dim>
  void
  sum_unseen(const PointCloud<dim> &points,
             const Occupancy<dim>  &occupancy,
             const GradientUse      gradient,
             const bool             is_consistent,
             const bool             linear_cells_only,
             GridState<dim>        &state);
} // namespace seiche

#endif
