// SPDX-License-Identifier: LGPL-2.1-or-later
// What GridParameters knows about periodic sides: no walls, but a seam.
#include <seiche/parameters/input_file.h>
#include <seiche/scene/grid_segments.h>
#include <seiche/scene/wall_slack.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  template <int dim>
  void
  GridParameters<dim>::check_periodic(const InputFile &input) const
  {
    for (unsigned int id = 0; id < 2 * dim; ++id)
      {
        const unsigned int other = id ^ 1u;
        if (walls[id].condition != WallCondition::periodic)
          continue;
        input.require(walls[other].condition == WallCondition::periodic,
                      walls[other].path(),
                      "\"" + walls[id].side_entry() +
                        "\" is periodic, and this side is the same place: set "
                        "both to periodic, or none.");
        for (const unsigned int side : {id, other})
          input.require(walls[side].displacement_text.empty(),
                        walls[side].path("displacement"),
                        "a periodic side is no wall; only walls move.");
      }
    for (unsigned int d = 0; d < dim; ++d)
      if (is_periodic(d))
        {
          const auto         segments = make_segments(*this, d);
          const unsigned int n = segments.back().first + segments.back().cells;
          input.require(
            n >= fewest_periodic_cells,
            cells[d].empty() ? "Grid/Cell size" :
                               fmt::format("Grid/Cells {}", "xyz"[d]),
            fmt::format("makes {} cell(s) in the periodic direction "
                        "{}; at least {} are needed.",
                        n,
                        "xyz"[d],
                        fewest_periodic_cells));
          check_periodic_obstacle(input, d);
        }
  }



  template <int dim>
  void
  GridParameters<dim>::check_periodic_obstacle(
    const InputFile   &input,
    const unsigned int direction) const
  {
    const double tolerance =
      wall_slack(upper_corner[direction] - lower_corner[direction]);
    for (const Wall<dim> &obstacle : obstacles())
      {
        const bool at_lower = obstacle.lower_corner[direction] <=
                              lower_corner[direction] + tolerance;
        const bool at_upper = obstacle.upper_corner[direction] >=
                              upper_corner[direction] - tolerance;
        input.require(at_lower == at_upper,
                      obstacle.path(at_lower ? "lower corner" : "upper corner"),
                      fmt::format("it touches the periodic side \"{}\" and not "
                                  "the opposite one: an obstacle reaches from "
                                  "one to the other or touches neither. Move "
                                  "the corners of the grid and all that stands "
                                  "in it along {}.",
                                  walls[BoxFace(direction, at_upper)].name,
                                  "xyz"[direction]));
      }
  }



  template <int dim>
  bool
  GridParameters<dim>::is_periodic(const unsigned int direction) const
  {
    return walls[2 * direction].condition == WallCondition::periodic;
  }



  template <int dim>
  bool
  GridParameters<dim>::any_periodic() const
  {
    return std::any_of(walls.begin(), walls.end(), [](const auto &wall) {
      return wall.condition == WallCondition::periodic;
    });
  }



  template void
  GridParameters<2>::check_periodic(const InputFile &) const;
  template bool
  GridParameters<2>::is_periodic(const unsigned int) const;
  template bool
  GridParameters<2>::any_periodic() const;
  template void
  GridParameters<3>::check_periodic(const InputFile &) const;
  template bool
  GridParameters<3>::is_periodic(const unsigned int) const;
  template bool
  GridParameters<3>::any_periodic() const;
} // namespace seiche
