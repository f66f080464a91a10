// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_shift_point_h
#define seiche_grid_shift_point_h

#include <seiche/points/point_cloud.h>

namespace seiche
{
  /// Move a point of an own cell by @p delta [cells], shortened before the cell's
  /// walls: the distance a from one becomes a^2/(a + |delta|). No point goes
  /// around the edge of an obstacle. Its velocity follows by the gradient that
  /// it carries.
  template <int dim>
  void
  shift_point(const unsigned int     cell,
              const std::size_t      point,
              dealii::Tensor<1, dim> delta,
              PointCloud<dim>       &points);
} // namespace seiche

#endif
