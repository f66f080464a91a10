// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_grid_segments_h
#define seiche_scene_grid_segments_h

#include <seiche/scene/grid_parameters.h>

#include <vector>

namespace seiche
{
  /// Equal cells between two grid lines of one direction.
  struct GridSegment
  {
    double       begin; // [m]
    double       end;   // [m]
    unsigned int first; // index of its first cell of level 0
    unsigned int cells; // number of cells of level 0
  };

  /**
   * The segments of one direction: between break points, split at the corners
   * of obstacles. An obstacle's corner inside a segment becomes a grid line:
   * where it coincides with one (to wall_slack()) nothing else changes,
   * elsewhere the segment's cells are shared out between its two parts in
   * proportion, at least one each.
   */
  template <int dim>
  std::vector<GridSegment>
  make_segments(const GridParameters<dim> &parameters,
                const unsigned int         direction);
} // namespace seiche

#endif
