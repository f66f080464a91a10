// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_wall_names_h
#define seiche_postprocess_wall_names_h

#include <seiche/parameters/input_file.h>
#include <seiche/scene/grid_parameters.h>

#include <string>
#include <vector>

namespace seiche
{
  /// Names of sides and obstacles, by boundary id, then of solids.
  template <int dim>
  std::vector<std::string>
  wall_names(const GridParameters<dim> &grid)
  {
    std::vector<std::string> names;
    for (const Wall<dim> &wall : grid.walls)
      names.push_back(wall.name);
    for (const Solid<dim> &solid : grid.solids)
      names.push_back(solid.name);
    return names;
  }

  /// Place of a solid among these names.
  template <int dim>
  unsigned int
  place_of_solid(const GridParameters<dim> &grid, const unsigned int solid)
  {
    return grid.walls.size() + solid;
  }

  /// InputError if the wall of that name, read at @p path, is a periodic side.
  template <int dim>
  void
  require_no_seam(const InputFile           &input,
                  const GridParameters<dim> &grid,
                  const std::string         &path,
                  const std::string         &name)
  {
    for (const Wall<dim> &wall : grid.walls)
      input.require(wall.name != name || wall.exists(),
                    path,
                    "the side \"" + name + "\" is periodic: there is no wall.");
  }
} // namespace seiche

#endif
