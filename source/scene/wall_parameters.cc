// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of GridParameters about walls: sides of the domain and obstacles.
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/wall_condition_table.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <array>

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
                          "themselves (what is normal to a face has no "
                          "effect there): one "
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
