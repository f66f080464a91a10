// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_point_sums_h
#define seiche_transfer_point_sums_h

#include <seiche/grid/grid_state.h>
#include <seiche/points/point_cloud.h>
#include <seiche/transfer/transfer.h>

namespace seiche
{
  /**
   * Masses of the nodes, sum_p m_p N_I, and in place of the fields that are
   * means weighted by them (pressure_guess, velocity_n, acceleration_n) their
   * sums (doc/theory.md (7.1)). Where components are zero in single cells, what
   * their points bring is taken out (sum_unseen()). @p is_consistent:
   * for the consistent mass matrix. Collective.
   */
  template <int dim>
  void
  sum_to_nodes(const PointCloud<dim> &points,
               const Occupancy<dim>  &occupancy,
               const GradientUse      gradient,
               const bool             is_consistent,
               const bool             linear_cells_only,
               GridState<dim>        &state);
} // namespace seiche

#endif
