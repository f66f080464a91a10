// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_smallest_cell_h
#define seiche_scene_smallest_cell_h

#include <seiche/scene/grid_parameters.h>

#include <string>

namespace seiche
{
  /// The shortest edge of the finest cells, which limits the time step.
  struct SmallestCell
  {
    double       edge      = 0.; ///< [m]
    unsigned int direction = 0;
    double       begin = 0., end = 0.; ///< of its segment [m]
    std::string  cause;                ///< paths of the entries that made it
  };

  /// Of the edges in one direction, without the cause. Local.
  template <int dim>
  SmallestCell
  smallest_edge(const GridParameters<dim> &grid, const unsigned int direction);

  /// Local.
  template <int dim>
  SmallestCell
  smallest_cell(const GridParameters<dim> &grid);
} // namespace seiche

#endif
