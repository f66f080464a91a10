// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/wall_condition_table.h>
#include <seiche/scene/wall_slack.h>

#include <algorithm>
#include <cmath>
#include <vector>

// The part of GridParameters that checks its walls: sides and obstacles.
namespace seiche
{
  namespace
  {
    WallCondition
    wall_condition_from_string(const std::string &text)
    {
      return std::find_if(wall_condition_table.begin(),
                          wall_condition_table.end(),
                          [&](const auto &entry) { return text == entry.name; })
        ->condition; // the pattern refuses other names
    }



    /// A corner that coincides with a grid line, of break points, sides and the
    /// obstacles before the wall @p end, is exactly there.
    template <int dim>
    void
    lay_on_lines(dealii::Point<dim>        &corner,
                 const GridParameters<dim> &grid,
                 const unsigned int         end)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          std::vector<double> lines = grid.break_points[d];
          lines.push_back(grid.lower_corner[d]);
          lines.push_back(grid.upper_corner[d]);
          for (unsigned int id = 2 * dim; id < end; ++id)
            {
              lines.push_back(grid.walls[id].lower_corner[d]);
              lines.push_back(grid.walls[id].upper_corner[d]);
            }
          const double slack =
            wall_slack(grid.upper_corner[d] - grid.lower_corner[d]);
          const auto line =
            std::find_if(lines.begin(), lines.end(), [&](const double place) {
              return std::abs(place - corner[d]) <= slack;
            });
          if (line != lines.end())
            corner[d] = *line;
        }
    }
  } // namespace



  template <int dim>
  void
  GridParameters<dim>::check_walls(const InputFile &input)
  {
    for (unsigned int id = 0; id < walls.size(); ++id)
      {
        WallCondition &condition = walls[id].condition;
        condition = wall_condition_from_string(walls_text[id].condition);
        if (contact == "unilateral" && condition == WallCondition::slip)
          condition = WallCondition::unilateral;
        if (walls[id].is_side())
          lay_side(walls[id]);
        else
          check_obstacle(input, id);
      }
    for (Wall<dim> &wall : walls)
      wall.build(input);
    check_friction(input);
    check_periodic(input);
  }



  template <int dim>
  void
  GridParameters<dim>::lay_side(Wall<dim> &wall) const
  {
    wall.lower_corner    = lower_corner;
    wall.upper_corner    = upper_corner;
    const unsigned int d = wall.side().direction();
    if (wall.side().is_upper())
      wall.lower_corner[d] = upper_corner[d];
    else
      wall.upper_corner[d] = lower_corner[d];
  }



  template <int dim>
  void
  GridParameters<dim>::check_obstacle(const InputFile   &input,
                                      const unsigned int id)
  {
    Wall<dim>        &here       = walls[id];
    const std::string lower_path = here.path("lower corner"),
                      upper_path = here.path("upper corner");
    here.lower_corner =
      entry_values::point<dim>(input, lower_path, walls_text[id].lower);
    here.upper_corner =
      entry_values::point<dim>(input, upper_path, walls_text[id].upper);

    for (dealii::Point<dim> *corner : {&here.lower_corner, &here.upper_corner})
      lay_on_lines(*corner, *this, id);

    bool fills_domain = true;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double tolerance = wall_slack(upper_corner[d] - lower_corner[d]);
        input.require(here.lower_corner[d] >= lower_corner[d] - tolerance,
                      lower_path,
                      "the obstacle reaches out of the domain.");
        input.require(here.upper_corner[d] <= upper_corner[d] + tolerance,
                      upper_path,
                      "the obstacle reaches out of the domain.");
        input.require(here.lower_corner[d] + tolerance < here.upper_corner[d],
                      upper_path,
                      "must be greater than \"Lower corner\" in every "
                      "direction.");
        fills_domain = fills_domain &&
                       here.lower_corner[d] <= lower_corner[d] + tolerance &&
                       here.upper_corner[d] >= upper_corner[d] - tolerance;
      }
    input.require(!fills_domain,
                  upper_path,
                  "the obstacle fills the whole domain.");
    for (unsigned int side = 0; side < 2 * dim; ++side)
      input.require(here.name != side_name<dim>(side),
                    lower_path,
                    "an obstacle cannot have the name of a side of the "
                    "domain; rename it.");
    for (unsigned int before = 2 * dim; before < id; ++before)
      {
        const Wall<dim> &other    = walls[before];
        bool             overlaps = true;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double tolerance =
              wall_slack(upper_corner[d] - lower_corner[d]);
            overlaps =
              overlaps &&
              here.lower_corner[d] + tolerance < other.upper_corner[d] &&
              other.lower_corner[d] + tolerance < here.upper_corner[d];
          }
        input.require(!overlaps,
                      lower_path,
                      "the obstacle overlaps \"" + other.name +
                        "\"; make it of boxes that at most touch.");
      }
  }



  template <int dim>
  void
  GridParameters<dim>::check_friction(const InputFile &input) const
  {
    for (const Wall<dim> &wall : walls)
      input.require(wall.friction == 0. ||
                      wall.condition == WallCondition::slip ||
                      wall.condition == WallCondition::unilateral,
                    wall.path("friction"),
                    "only walls along which the fluid slips have friction: "
                    "set the condition to slip or unilateral, or this entry "
                    "to 0.");
    if (any_unilateral())
      input.cites("hueeber2005");
    if (any_friction())
      input.cites("schlichting1979");
  }



  template void
  GridParameters<2>::check_walls(const InputFile &);
  template void
  GridParameters<3>::check_walls(const InputFile &);
} // namespace seiche
