// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/background_grid.h>
#include <seiche/scene/entry_values.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace seiche
{
  namespace
  {
    /// Cells of the finest lattice along a direction: all of them are counted
    /// in 64 bits, those along one in 32.
    template <int dim>
    constexpr double largest_line = dim == 2 ? 2147483647. : 2097151.;

    /// Entry of a side in "Walls": its name with a capital letter.
    template <int dim>
    std::string
    side_entry(const unsigned int id)
    {
      std::string name = side_name<dim>(id);
      name[0]          = std::toupper(name[0]);
      return name;
    }



    WallCondition
    wall_condition_from_string(const std::string &text)
    {
      if (text == "slip")
        return WallCondition::slip;
      if (text == "unilateral")
        return WallCondition::unilateral;
      if (text == "no-slip")
        return WallCondition::no_slip;
      if (text == "open")
        return WallCondition::open;
      AssertThrow(false, dealii::ExcMessage("Unknown wall: " + text));
      return WallCondition::slip;
    }



    const char *const friction_text =
      "Skin friction coefficient c_f of a slip or unilateral wall: drag c_f/2 "
      "rho |v| v per area, of boundary layers thinner than a cell; 0: none. "
      "Smooth walls 0.003 to 0.01; Darcy's f/4; 2 g n^2/depth^(1/3) of "
      "Manning's n. [-]";



    std::string
    per_direction(const std::string &entry, const unsigned int direction)
    {
      return fmt::format("{} {}", entry, "xyz"[direction]);
    }
  } // namespace



  template <int dim>
  GridParameters<dim>::GridParameters(const InputFile &input)
    : refinement(input)
  {
    walls_text.fill("slip");
    walls.fill(WallCondition::slip);
    for (const std::string &name : input.instances("Obstacle"))
      {
        obstacles_text.emplace_back();
        obstacles_text.back().name = name;
      }
  }



  template <int dim>
  void
  GridParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::Anything anything;
    prm.enter_subsection("Grid");
    prm.add_parameter("Lower corner",
                      lower_text,
                      "Corner of the box domain with the smallest "
                      "coordinates. [m]",
                      anything,
                      /*has_to_be_set=*/true);
    prm.add_parameter("Upper corner",
                      upper_text,
                      "Corner of the box domain with the greatest "
                      "coordinates. [m]",
                      anything,
                      /*has_to_be_set=*/true);
    prm.add_parameter("Cell size",
                      cell_size,
                      "Wanted edge length of the cells; every segment gets "
                      "the nearest whole number of equal cells. Needed in "
                      "directions without \"Cells\". [m]",
                      dealii::Patterns::Double(0.));
    for (unsigned int d = 0; d < dim; ++d)
      {
        prm.add_parameter(per_direction("Break points", d),
                          break_points_text[d],
                          "Ascending places inside the domain that have to "
                          "be grid lines. They cut the direction into "
                          "segments of equal cells, as do the corners of "
                          "obstacles. [m]");
        prm.add_parameter(per_direction("Cells", d),
                          cells_text[d],
                          "Numbers of cells, one per segment between break "
                          "points; overrides \"Cell size\". A segment that "
                          "the corner of an obstacle cuts shares them out "
                          "in proportion. [-]");
      }
    prm.leave_subsection();

    prm.enter_subsection("Walls");
    for (unsigned int id = 0; id < 2 * dim; ++id)
      prm.add_parameter(side_entry<dim>(id),
                        walls_text[id],
                        "slip: no flow to or from the wall; unilateral: the "
                        "same, but the fluid may leave it; no-slip: the fluid "
                        "sticks to it; open: fluid may leave the domain.",
                        dealii::Patterns::Selection(
                          "slip|unilateral|no-slip|open"));
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
                          "its faces become grid lines. [m]",
                          anything,
                          /*has_to_be_set=*/true);
        prm.add_parameter("Upper corner",
                          obstacle.upper,
                          "Opposite corner of the box. [m]",
                          anything,
                          /*has_to_be_set=*/true);
        prm.add_parameter("Condition",
                          obstacle.condition,
                          "slip: no flow to or from the faces; unilateral: "
                          "the same, but the fluid may leave them; no-slip: "
                          "the fluid sticks to them.",
                          dealii::Patterns::Selection(
                            "slip|unilateral|no-slip"));
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
    refinement.add_parameters(prm);
  }



  template <int dim>
  void
  GridParameters<dim>::check(const InputFile &input)
  {
    lower_corner =
      entry_values::point<dim>(input, "Grid/Lower corner", lower_text);
    upper_corner =
      entry_values::point<dim>(input, "Grid/Upper corner", upper_text);
    for (unsigned int d = 0; d < dim; ++d)
      input.require(lower_corner[d] < upper_corner[d],
                    "Grid/Upper corner",
                    "must be greater than \"Lower corner\" in every "
                    "direction.");
    for (unsigned int d = 0; d < dim; ++d)
      check_lines(input, d);
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
    check_size(input);
    refinement.check(input, *this);
  }



  template <int dim>
  void
  GridParameters<dim>::check_lines(const InputFile   &input,
                                   const unsigned int direction)
  {
    const std::string breaks_path =
      "Grid/" + per_direction("Break points", direction);
    const std::string cells_path = "Grid/" + per_direction("Cells", direction);

    break_points[direction] =
      entry_values::numbers(input, breaks_path, break_points_text[direction]);
    double last = lower_corner[direction];
    for (const double place : break_points[direction])
      {
        input.require(place > last && place < upper_corner[direction],
                      breaks_path,
                      fmt::format("{:g} m is not between {:g} and {:g} m; "
                                  "break points have to ascend and to lie "
                                  "inside the domain.",
                                  place,
                                  last,
                                  upper_corner[direction]));
        last = place;
      }

    cells[direction] =
      entry_values::counts(input, cells_path, cells_text[direction]);
    const unsigned int n_segments = break_points[direction].size() + 1;
    if (cells[direction].empty())
      input.require(cell_size > 0.,
                    "Grid/Cell size",
                    "must be greater than zero [m], or give the numbers of "
                    "cells by \"" +
                      per_direction("Cells", direction) + "\".");
    else
      input.require(cells[direction].size() == n_segments,
                    cells_path,
                    fmt::format("{} number(s) given; {} needed, one for "
                                "each segment between break points.",
                                cells[direction].size(),
                                n_segments));
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

    bool fills_domain = true;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double tolerance = 1e-9 * (upper_corner[d] - lower_corner[d]);
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
      {
        input.require(text.name != side_name<dim>(id),
                      path + "Lower corner",
                      "an obstacle cannot have the name of a side of the "
                      "domain; rename it.");
      }
  }



  template <int dim>
  void
  GridParameters<dim>::check_friction(const InputFile &input) const
  {
    for (unsigned int id = 0; id < 2 * dim + obstacles.size(); ++id)
      {
        const bool is_side = id < 2 * dim;
        const auto condition =
          is_side ? walls[id] : obstacles[id - 2 * dim].condition;
        input.require(friction(id) == 0. || condition == WallCondition::slip ||
                        condition == WallCondition::unilateral,
                      is_side ? "Walls/" + side_entry<dim>(id) + " friction" :
                                "Obstacle " + obstacles[id - 2 * dim].name +
                                  "/Friction",
                      "only walls along which the fluid slips have friction: "
                      "set the condition to slip or unilateral, or this entry "
                      "to 0.");
      }
  }



  template <int dim>
  void
  GridParameters<dim>::check_size(const InputFile &input) const
  {
    const char *entry = cells[0].empty() ? "Grid/Cell size" : "Grid/Cells x";
    const unsigned int level  = refinement.finest_level();
    double             n_rows = dim;
    for (unsigned int d = 0; d < dim; ++d)
      {
        // the lattice is stored as unsigned int, so test before it is made
        double n_cells = 0.;
        for (const unsigned int n : cells[d])
          n_cells += n;
        if (cells[d].empty())
          n_cells = (upper_corner[d] - lower_corner[d]) / cell_size;
        n_rows *= n_cells + 1.;
        const double n_finest = std::ldexp(n_cells, level);
        input.require(n_finest < largest_line<dim>,
                      entry,
                      fmt::format("makes {:.3g} cells of the finest level ({}) "
                                  "in direction {}; at most {:.3g} are "
                                  "possible. Choose larger cells or smaller "
                                  "levels of refinement.",
                                  n_finest,
                                  level,
                                  "xyz"[d],
                                  largest_line<dim>));
      }
    input.require(n_rows <= std::numeric_limits<int>::max(),
                  entry,
                  fmt::format("makes {:.3g} rows in the velocity block; at "
                              "most 2^31 - 1 are possible. Choose larger "
                              "cells.",
                              n_rows));
  }



  template <int dim>
  bool
  GridParameters<dim>::any_unilateral() const
  {
    return std::count(walls.begin(), walls.end(), WallCondition::unilateral) >
             0 ||
           std::any_of(obstacles.begin(),
                       obstacles.end(),
                       [](const Obstacle &obstacle) {
                         return obstacle.condition == WallCondition::unilateral;
                       });
  }



  template <int dim>
  double
  GridParameters<dim>::friction(const unsigned int id) const
  {
    return id < 2 * dim ? walls_friction[id] : obstacles[id - 2 * dim].friction;
  }



  template <int dim>
  bool
  GridParameters<dim>::any_friction() const
  {
    for (unsigned int id = 0; id < 2 * dim + obstacles.size(); ++id)
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



  template <int dim>
  dealii::BoundingBox<dim>
  GridParameters<dim>::domain() const
  {
    return dealii::BoundingBox<dim>({lower_corner, upper_corner});
  }



  template struct GridParameters<2>;
  template struct GridParameters<3>;
} // namespace seiche
