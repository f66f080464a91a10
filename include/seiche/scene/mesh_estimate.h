// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_mesh_estimate_h
#define seiche_scene_mesh_estimate_h

#include <seiche/scene/scene_map.h>

namespace seiche
{
  /**
   * @brief Numbers of cells at the start, counted without making a mesh.
   *
   * Exact for a uniform mesh with few obstacles; of an adaptive one within a
   * factor of two: the cells that grade from level to level are not counted.
   */
  struct MeshEstimate
  {
    double cells    = 0.;
    double occupied = 0.; ///< of these, cells with fluid or cut by its surface
    double full     = 0.; ///< cells of the finest level that the fluid fills
    double surface  = 0.; ///< cells at the free surface
  };

  /// Local.
  template <int dim>
  MeshEstimate
  estimate_mesh(const GridParameters<dim> &grid, const SceneMap<dim> &map);
} // namespace seiche

#endif
