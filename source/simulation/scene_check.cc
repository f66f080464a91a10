// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_problems.h>
#include <seiche/scene/grid_motion.h>
#include <seiche/simulation/scene.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <functional>
#include <string>

// The part of Scene that refuses what does not fit together.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// What walls that cut cells need.
    template <int dim>
    void
    check_solids(const Scene<dim> &scene)
    {
      std::vector<std::string> names;
      for (const Wall<dim> &wall : scene.grid.walls)
        names.push_back(wall.name);
      for (const auto &solid : scene.solids)
        {
          const std::string path = solid.shape.path("Shape");
          const auto require = [&](const bool good, const std::string &text) {
            scene.input.require(good, path, text);
          };
          require(std::find(names.begin(), names.end(), solid.name) ==
                    names.end(),
                  "a side or an obstacle has the name \"" + solid.name +
                    "\", too; rename the solid.");
          require(
            scene.formulation.is_mixed(),
            "walls of solids need Formulation/Name = "
            "displacement-pressure: they hold the fluid by its pressure.");
          require(scene.quadrature.has_surface(),
                  "walls of solids need Quadrature/Rule = cut cells.");
          require(!scene.time_scheme.needs_acceleration(),
                  "walls of solids need Time/Scheme = generalized midpoint.");
          require(!scene.grid.any_periodic(),
                  "a domain with periodic sides holds no solids: use Obstacle "
                  "NAME, or walls in place of the periodic sides.");
          require(!scene.grid.any_displaced(),
                  "a side that moves along its normal and solids do not go "
                  "together: use Obstacle NAME, or Tank motion.");
        }
      scene.input.require(!scene.tank_motion.body.any() ||
                            !any_is_free(scene.grid.solids),
                          scene.tank_motion.body.path("Free"),
                          "a tank and solids that the fluid moves do not go "
                          "together: leave it, or Free of the solids, empty.");
      scene.input.require(!scene.tank_motion.turns() ||
                            !any_is_free(scene.grid.solids),
                          scene.tank_motion.body.path("Rotation"),
                          "solids that the fluid moves do not feel the turning "
                          "of a tank: leave it, or Free of the solids, empty.");
      if (!scene.solids.empty())
        scene.input.cites("nitsche1971");
    }

    /// What some walls, forces of sound and the error of a step need.
    template <int dim>
    void
    check_scheme(const Scene<dim> &scene)
    {
      scene.input.require(
        !(scene.grid.any_unilateral() || scene.grid.any_friction() ||
          scene.grid.any_displaced() || scene.tank_motion.body.any()) ||
          !scene.time_scheme.needs_acceleration(),
        "Time/Scheme",
        "unilateral walls, walls with friction and walls with a "
        "displacement need generalized midpoint: the other schemes carry an "
        "acceleration that jumps where the fluid meets a wall; so does a tank "
        "that the fluid moves (Tank motion/Free), whose forces are means of a "
        "step");
      scene.input.require(
        scene.time_scheme.is_elastic_at_end() ||
          (!scene.time_scheme.needs_acceleration() &&
           !scene.fluid.is_incompressible()),
        "Time/Elastic pressure",
        "middle needs Scheme = generalized midpoint and a finite Fluid/Bulk "
        "modulus: an incompressible fluid has no sound; set it to end");
      scene.input.require(
        !scene.time.controls_error() || scene.time_scheme.is_second_order(),
        "Time/Step control",
        "error needs a scheme of second order: set Rho infinity = 1");
    }
  } // namespace

  template <int dim>
  void
  Scene<dim>::check(const InputFile &input_file)
  {
    std::vector<std::function<void()>> of_sections = {
      [&]() { grid.check(input_file); },
      [&]() { body_force.check(input_file, time.end_time); },
      [&]() { tank_motion.check(input_file); },
      [&]() { fluid.check(input_file); },
      [&]() { seeding.check(input_file); },
      [&]() { formulation.check(input_file); },
      [&]() { time.check(input_file); }};
    for (const auto &table : tables)
      of_sections.emplace_back([&]() { table.check(input_file); });
    for (const auto &body : bodies)
      of_sections.emplace_back([&]() { body.check(input_file); });
    for (const auto &solid : solids)
      of_sections.emplace_back([&]() { solid.check(input_file); });
    of_sections.emplace_back([&]() {
      std::vector<std::string> used;
      for (const auto &body : bodies)
        for (const std::string &part : body.shape.parts())
          used.push_back(part);
      for (const auto &solid : solids)
        for (const std::string &part : solid.shape.parts())
          used.push_back(part);
      check_named_shapes(input_file, shapes, used);
    });
    for (auto &material : further_materials)
      of_sections.emplace_back([&]() { material.check(input_file); });
    require_all(of_sections);
    grid.solids = make_solids(
      solids, input_file, grid.domain(), shapes, time.end_time, time.step);
    add_moorings(moorings, input_file, grid.solids);
    check_materials(input_file);
    check_choices(input_file);
    check_scheme(*this);
    check_solids(*this);
    if (bodies.empty())
      throw InputError(input_file.filename +
                       ": no fluid; add a subsection 'Fluid body NAME' with "
                       "its Shape");
    input_file.require(formulation.is_mixed() || !fluid.is_incompressible(),
                       "Fluid/Bulk modulus",
                       "the irreducible form needs a finite one [Pa], about "
                       "density * (10 * largest speed)^2; or set "
                       "Formulation/Name = displacement-pressure");
    input_file.require(
      transfer_method(transfer.method).update !=
          VelocityUpdate::flip_acceleration ||
        time_scheme.has_newmark_rule(),
      "Transfer/Method",
      "FLIP acceleration updates velocities by Newmark's rule: set Time/Scheme "
      "= newmark, or another method");
    input_file.require(!tank_motion.turns() || !grid.any_periodic(),
                       tank_motion.rotation.empty() ? "Tank motion/Free" :
                                                      "Tank motion/Rotation",
                       "a tank with periodic sides cannot turn: accelerations "
                       "would differ at the two sides. Leave it empty, or give "
                       "the tank walls.");
    postprocessors.check(grid,
                         time.end_time,
                         simulation_columns(),
                         summary_numbers(),
                         tank_motion.any());
  }

  template <int dim>
  void
  Scene<dim>::check_choices(const InputFile &input_file)
  {
    const bool is_mixed = formulation.is_mixed();
    input_file.read_only_if(is_mixed,
                            "Time/Velocity projection",
                            "Formulation/Name = displacement-pressure");
    input_file.read_only_if(quadrature.has_surface(),
                            "Points/Density rate",
                            "Quadrature/Rule = cut cells");
    if (quadrature.has_surface())
      input_file.cites(point_control.density_rate > 0. ?
                         "saye2015 kugelstadt2021" :
                         "saye2015");
    if (volume_update() == VolumeUpdate::nodal_mean)
      input_file.cites("bonet1998");
    const bool has_gradient = Transfer<dim>::columns(transfer).count(
                                PointColumn::velocity_gradient) > 0;
    require_all(
      {[&]() {
         for (const Wall<dim> &wall : grid.walls)
           wall.check(input_file, grid.domain(), time.end_time);
         GridMotion<dim>(grid, time.end_time).check(input_file);
       },
       [&]() { (void)make_tank_motion(); },
       [&]() { free_surface.check(input_file, is_mixed); },
       [&]() {
         time_scheme.check(input_file, is_mixed && fluid.is_incompressible());
       },
       [&]() {
         transfer.check(input_file, formulation.degree, seeding.per_direction);
       },
       [&]() { volume.check(input_file, has_pressure_of_end()); },
       [&]() { linear_solver.check(input_file, is_mixed); },
       [&]() {
         point_control.check(input_file,
                             has_gradient,
                             Utilities::fixed_power<dim>(
                               seeding.per_direction));
       }});
  }

  template <int dim>
  void
  Scene<dim>::check_materials(const InputFile &input_file)
  {
    materials = {fluid.material.material()};
    for (const MaterialParameters &material : further_materials)
      {
        materials.push_back(material.material());
        const bool is_used =
          std::any_of(bodies.begin(), bodies.end(), [&](const auto &body) {
            return body.material == material.name;
          });
        for (const char *entry : {"/Density", "/Dynamic viscosity"})
          input_file.read_only_if(is_used,
                                  material.section() + entry,
                                  "a Fluid body with Material = " +
                                    material.name);
      }
  }

  template void
  Scene<2>::check(const InputFile &);
  template void
  Scene<3>::check(const InputFile &);
} // namespace seiche
