// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of GridParameters about walls: sides of the domain and obstacles.
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/side_entry.h>
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
    /// obstacles before, is exactly there.
    template <int dim>
    void
    lay_on_lines(dealii::Point<dim>        &corner,
                 const GridParameters<dim> &grid,
                 const unsigned int         n_before)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          std::vector<double> lines = grid.break_points[d];
          lines.push_back(grid.lower_corner[d]);
          lines.push_back(grid.upper_corner[d]);
          for (unsigned int i = 0; i < n_before; ++i)
            {
              lines.push_back(grid.obstacles[i].lower_corner[d]);
              lines.push_back(grid.obstacles[i].upper_corner[d]);
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
  GridParameters<dim>::add_wall_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::Anything anything;
    prm.enter_subsection("Walls");
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(side_entry<dim>(id),
                        walls_text[id],
                        conditions(/*of_obstacle=*/false).second,
                        dealii::Patterns::Selection(
                          conditions(/*of_obstacle=*/false).first));
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(side_entry<dim>(id) + " displacement",
                        displacements_text[id],
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
      prm.add_parameter(side_entry<dim>(id) + " velocity",
                        velocities_text[id],
                        "Velocity of a no-slip wall along itself, as of a lid "
                        "or a belt: one expression of x, y[, z], t per "
                        "direction, separated by \";\"; empty: at rest. "
                        "[m/s]",
                        anything);
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(side_entry<dim>(id) + " friction",
                        walls_friction[id],
                        friction_text,
                        dealii::Patterns::Double(0.));
    prm.leave_subsection();

    for (ObstacleText &obstacle : obstacles_text)
      {
        prm.enter_subsection("Obstacle " + obstacle.name);
        prm.add_parameter("Lower corner",
                          obstacle.lower,
                          "Corner of the box that is cut out of the grid; "
                          "its faces become grid lines, or lie on those that "
                          "are within 1e-9 of the domain. [m]",
                          anything,
                          /*has_to_be_set=*/true);
        prm.add_parameter("Upper corner",
                          obstacle.upper,
                          "Opposite corner of the box. [m]",
                          anything,
                          /*has_to_be_set=*/true);
        prm.add_parameter("Condition",
                          obstacle.condition,
                          conditions(/*of_obstacle=*/true).second,
                          dealii::Patterns::Selection(
                            conditions(/*of_obstacle=*/true).first));
        prm.add_parameter("Velocity",
                          obstacle.velocity,
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
    for (unsigned int id = 0; id < 2 * dim; ++id)
      walls[id] = wall_condition_from_string(walls_text[id]);
    obstacles.resize(obstacles_text.size());
    for (unsigned int i = 0; i < obstacles.size(); ++i)
      check_obstacle(input, i);
    if (contact == "unilateral")
      {
        const auto let_go = [](WallCondition &condition) {
          if (condition == WallCondition::slip)
            condition = WallCondition::unilateral;
        };
        std::for_each(walls.begin(), walls.end(), let_go);
        for (Obstacle &obstacle : obstacles)
          let_go(obstacle.condition);
      }
    check_friction(input);
    check_periodic(input);
  }



  template <int dim>
  void
  GridParameters<dim>::check_obstacle(const InputFile   &input,
                                      const unsigned int index)
  {
    const ObstacleText &text = obstacles_text[index];
    const std::string   path = "Obstacle " + text.name + "/";
    Obstacle           &here = obstacles[index];
    here.name                = text.name;
    here.condition           = wall_condition_from_string(text.condition);
    here.friction            = text.friction;
    here.lower_corner =
      entry_values::point<dim>(input, path + "Lower corner", text.lower);
    here.upper_corner =
      entry_values::point<dim>(input, path + "Upper corner", text.upper);

    for (dealii::Point<dim> *corner : {&here.lower_corner, &here.upper_corner})
      lay_on_lines(*corner, *this, index);

    bool fills_domain = true;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double tolerance = wall_slack(upper_corner[d] - lower_corner[d]);
        input.require(here.lower_corner[d] >= lower_corner[d] - tolerance,
                      path + "Lower corner",
                      "the obstacle reaches out of the domain.");
        input.require(here.upper_corner[d] <= upper_corner[d] + tolerance,
                      path + "Upper corner",
                      "the obstacle reaches out of the domain.");
        input.require(here.lower_corner[d] + tolerance < here.upper_corner[d],
                      path + "Upper corner",
                      "must be greater than \"Lower corner\" in every "
                      "direction.");
        fills_domain = fills_domain &&
                       here.lower_corner[d] <= lower_corner[d] + tolerance &&
                       here.upper_corner[d] >= upper_corner[d] - tolerance;
      }
    input.require(!fills_domain,
                  path + "Upper corner",
                  "the obstacle fills the whole domain.");
    for (unsigned int id = 0; id < 2 * dim; ++id)
      input.require(text.name != side_name<dim>(id),
                    path + "Lower corner",
                    "an obstacle cannot have the name of a side of the "
                    "domain; rename it.");
    for (unsigned int other = 0; other < index; ++other)
      {
        bool overlaps = true;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double tolerance =
              wall_slack(upper_corner[d] - lower_corner[d]);
            overlaps = overlaps &&
                       here.lower_corner[d] + tolerance <
                         obstacles[other].upper_corner[d] &&
                       obstacles[other].lower_corner[d] + tolerance <
                         here.upper_corner[d];
          }
        input.require(!overlaps,
                      path + "Lower corner",
                      "the obstacle overlaps \"" + obstacles[other].name +
                        "\"; make it of boxes that at most touch.");
      }
  }



  template <int dim>
  void
  GridParameters<dim>::check_friction(const InputFile &input) const
  {
    for (unsigned int id = 0; id < n_walls(); ++id)
      input.require(friction(id) == 0. ||
                      wall_condition(id) == WallCondition::slip ||
                      wall_condition(id) == WallCondition::unilateral,
                    id < 2 * dim ?
                      "Walls/" + side_entry<dim>(id) + " friction" :
                      "Obstacle " + obstacles[id - 2 * dim].name + "/Friction",
                    "only walls along which the fluid slips have friction: "
                    "set the condition to slip or unilateral, or this entry "
                    "to 0.");
    if (any_unilateral())
      input.cites("hueeber2005");
    if (any_friction())
      input.cites("schlichting1979");
  }



  template <int dim>
  unsigned int
  GridParameters<dim>::n_walls() const
  {
    return 2 * dim + obstacles.size();
  }



  template <int dim>
  std::string
  GridParameters<dim>::wall_name(const unsigned int id) const
  {
    return id < 2 * dim ? side_name<dim>(id) : obstacles[id - 2 * dim].name;
  }



  template <int dim>
  WallCondition
  GridParameters<dim>::wall_condition(const unsigned int id) const
  {
    return id < 2 * dim ? walls[id] : obstacles[id - 2 * dim].condition;
  }



  template <int dim>
  double
  GridParameters<dim>::friction(const unsigned int id) const
  {
    return id < 2 * dim ? walls_friction[id] : obstacles[id - 2 * dim].friction;
  }



  template <int dim>
  bool
  GridParameters<dim>::any_unilateral() const
  {
    for (unsigned int id = 0; id < n_walls(); ++id)
      if (wall_condition(id) == WallCondition::unilateral)
        return true;
    return false;
  }



  template <int dim>
  bool
  GridParameters<dim>::any_friction() const
  {
    for (unsigned int id = 0; id < n_walls(); ++id)
      if (friction(id) > 0.)
        return true;
    return false;
  }



  template <int dim>
  std::string
  GridParameters<dim>::wall_velocity_text(const unsigned int id) const
  {
    return id < 2 * dim ? velocities_text[id] :
                          obstacles_text[id - 2 * dim].velocity;
  }



  template <int dim>
  std::string
  GridParameters<dim>::wall_velocity_path(const unsigned int id) const
  {
    return id < 2 * dim ?
             "Walls/" + side_entry<dim>(id) + " velocity" :
             "Obstacle " + obstacles_text[id - 2 * dim].name + "/Velocity";
  }



  template <int dim>
  const std::string &
  GridParameters<dim>::wall_displacement_text(const unsigned int side) const
  {
    return displacements_text[side];
  }



  template <int dim>
  std::string
  GridParameters<dim>::wall_displacement_path(const unsigned int side) const
  {
    return "Walls/" + side_entry<dim>(side) + " displacement";
  }



  template struct GridParameters<2>;
  template struct GridParameters<3>;
  template std::string
  side_name<2>(const unsigned int);
  template std::string
  side_name<3>(const unsigned int);
} // namespace seiche
