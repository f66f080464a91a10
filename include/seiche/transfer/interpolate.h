// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_interpolate_h
#define seiche_transfer_interpolate_h

#include <seiche/points/point_cloud.h>
#include <seiche/space/occupancy.h>

namespace seiche
{
  /// Set a vector column of the points to @p keep times itself plus a nodal
  /// vector field (ghosts valid) at their positions: of the consistent start,
  /// a_p = N a_0 (doc/theory.md (3.6)). Local.
  template <int dim>
  void
  interpolate_to_points(const Occupancy<dim>                  &occupancy,
                        const typename Occupancy<dim>::Vector &field,
                        const PointColumn                      column,
                        PointCloud<dim>                       &points,
                        const double                           keep = 0.);
} // namespace seiche

#endif
