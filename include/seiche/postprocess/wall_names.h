// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_wall_names_h
#define seiche_postprocess_wall_names_h

#include <seiche/scene/grid_parameters.h>

#include <string>
#include <vector>

namespace seiche
{
  /// Names of sides and obstacles, by boundary id.
  template <int dim>
  std::vector<std::string>
  wall_names(const GridParameters<dim> &grid)
  {
    std::vector<std::string> names;
    for (unsigned int id = 0; id < grid.n_walls(); ++id)
      names.push_back(grid.wall_name(id));
    return names;
  }
} // namespace seiche

#endif
