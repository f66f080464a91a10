// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_solid_distances_h
#define seiche_mesh_solid_distances_h

#include <seiche/scene/solid.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Distances from the nearest solid at places of the mesh. Beside
   * solids that move, those at rest are not asked again until the places
   * change: a height map costs more than all else that a step does there.
   */
  template <int dim>
  class SolidDistances
  {
  public:
    /// At each place [m], positive in the fluid. There must be solids. Local.
    std::vector<double>
    at(const std::vector<Solid<dim>>         &solids,
       const std::vector<dealii::Point<dim>> &places);

  private:
    std::vector<dealii::Point<dim>> kept_places; // empty: nothing is kept
    std::vector<double>             of_solids_at_rest;
  };
} // namespace seiche

#endif
