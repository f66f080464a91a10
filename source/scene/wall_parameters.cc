// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of GridParameters about walls: sides of the domain and obstacles.
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/wall_condition_table.h>
#include <seiche/scene/wall_slack.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace seiche
{
  template <int dim>
  std::string
  side_name(const unsigned int id)
  {
    const std::array<const char *, 4> names_2d = {
      {"left", "right", "bottom", "top"}};
    const std::array<const char *, 6> names_3d = {
      {"left", "right", "front", "back", "bottom", "top"}};
    AssertIndexRange(id, 2 * dim);
    return dim == 2 ? names_2d[id] : names_3d[id];
  }



  namespace
  {
    /// Allowed names, and what they mean.
    std::pair<std::string, std::string>
    conditions(const bool of_obstacle)
    {
      std::string names, meaning;
      for (const WallConditionEntry &entry : wall_condition_table)
        if (entry.of_obstacles || !of_obstacle)
          {
            names += (names.empty() ? "" : "|") + std::string(entry.name);
            meaning += (meaning.empty() ? "" : "; ") + std::string(entry.name) +
                       ": " + entry.text;
          }
      return {names, meaning + "."};
    }

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



    const char *const friction_text =
      "Skin friction coefficient c_f of a slip or unilateral wall: drag c_f/2 "
      "rho |v| v per area, of boundary layers thinner than a cell; 0: none. "
      "Smooth walls 0.003 to 0.01; Darcy's f/4; 2 g n^2/depth^(1/3) of "
      "Manning's n. [-]";
  } // namespace



  template <int dim>
  void
  GridParameters<dim>::add_side_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::Anything anything;
    prm.enter_subsection("Walls");
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(walls[id].side_entry(),
                        walls_text[id].condition,
                        conditions(/*of_obstacle=*/false).second,
                        dealii::Patterns::Selection(
                          conditions(/*of_obstacle=*/false).first));
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(walls[id].side_entry() + " displacement",
                        walls[id].displacement_text,
                        "Motion of the wall along its normal, as of a piston: "
                        "an expression of t, positive along the coordinate, 0 "
                        "at t = 0. The grid is stretched up to the next "
                        "obstacle or the opposite side; empty: at rest. [m]",
                        anything);
    prm.add_parameter("Contact",
                      contact,
                      "Of all slip walls and obstacles. sticking: the fluid "
                      "does not leave them; unilateral: as if each had the "
                      "condition unilateral.",
                      dealii::Patterns::Selection("sticking|unilateral"));
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(walls[id].side_entry() + " velocity",
                        walls[id].velocity_text,
                        "Velocity of a no-slip wall along itself, as of a lid "
                        "or a belt: one expression of x, y[, z], t per "
                        "direction, separated by \";\"; empty: at rest. "
                        "[m/s]",
                        anything);
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(walls[id].side_entry() + " friction",
                        walls[id].friction,
                        friction_text,
                        dealii::Patterns::Double(0.));
    prm.leave_subsection();
  }



  template <int dim>
  void
  GridParameters<dim>::add_obstacle_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::Anything anything;
    for (unsigned int id = 2 * dim; id < walls.size(); ++id)
      {
        Wall<dim> &obstacle = walls[id];
        WallText  &text     = walls_text[id];
        prm.enter_subsection("Obstacle " + obstacle.name);
        prm.add_parameter("Lower corner",
                          text.lower,
                          "Corner of the box that is cut out of the grid; "
                          "its faces become grid lines, or lie on those that "
                          "are within 1e-9 of the domain. [m]",
                          anything,
                          /*has_to_be_set=*/true);
        prm.add_parameter("Upper corner",
                          text.upper,
                          "Opposite corner of the box. [m]",
                          anything,
                          /*has_to_be_set=*/true);
        prm.add_parameter("Condition",
                          text.condition,
                          conditions(/*of_obstacle=*/true).second,
                          dealii::Patterns::Selection(
                            conditions(/*of_obstacle=*/true).first));
        prm.add_parameter("Velocity",
                          obstacle.velocity_text,
                          "Velocity of the faces of a no-slip obstacle along "
                          "themselves, as of a turning cylinder: one "
                          "expression of x, y[, z], t per direction, "
                          "separated by \";\"; empty: at rest. [m/s]",
                          anything);
        prm.add_parameter("Friction",
                          obstacle.friction,
                          friction_text,
                          dealii::Patterns::Double(0.));
        prm.leave_subsection();
      }
  }



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



  template <int dim>
  bool
  GridParameters<dim>::any_displaced() const
  {
    return std::any_of(walls.begin(), walls.end(), [](const auto &wall) {
      return wall.is_displaced();
    });
  }



  template <int dim>
  bool
  GridParameters<dim>::any_moving() const
  {
    return std::any_of(walls.begin(), walls.end(), [](const auto &wall) {
      return wall.is_displaced() || wall.slides();
    });
  }



  template <int dim>
  bool
  GridParameters<dim>::any_unilateral() const
  {
    return std::any_of(walls.begin(), walls.end(), [](const auto &wall) {
      return wall.condition == WallCondition::unilateral;
    });
  }



  template <int dim>
  bool
  GridParameters<dim>::any_friction() const
  {
    return std::any_of(walls.begin(), walls.end(), [](const auto &wall) {
      return wall.friction > 0.;
    });
  }



  template struct GridParameters<2>;
  template struct GridParameters<3>;
  template std::string
  side_name<2>(const unsigned int);
  template std::string
  side_name<3>(const unsigned int);
} // namespace seiche
