// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_problems.h>
#include <seiche/scene/grid_motion.h>
#include <seiche/simulation/accepted_failures.h>
#include <seiche/simulation/scene.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <functional>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// What some walls, forces of sound and the error of a step need.
    template <int dim>
    void
    check_scheme(const Scene<dim> &scene)
    {
      scene.input.require(
        !(scene.grid.any_unilateral() || scene.grid.any_friction() ||
          scene.grid.any_displaced()) ||
          !scene.time_scheme.needs_acceleration(),
        "Time/Scheme",
        "unilateral walls, walls with friction and walls with a "
        "displacement need generalized midpoint: the other schemes carry an "
        "acceleration that jumps where the fluid meets a wall");
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
  Scene<dim>::Scene(const InputFile &input_file)
    : input(input_file)
    , grid(input_file)
    , postprocessors(input_file)
  {
    for (const std::string &name : input.instances("Fluid body"))
      {
        bodies.emplace_back();
        bodies.back().name = name;
      }
    for (const std::string &name : input.instances(MaterialParameters::kind))
      {
        further_materials.emplace_back();
        further_materials.back().name = name;
      }
    for (const std::string &name : input.instances(TableParameters::kind))
      {
        tables.emplace_back();
        tables.back().name = name;
      }
  }

  template <int dim>
  void
  Scene<dim>::add_parameters(ParameterHandler &prm)
  {
    grid.add_parameters(prm);
    for (auto &table : tables)
      {
        prm.enter_subsection(std::string(TableParameters::kind) + " " +
                             table.name);
        table.add_parameters(prm);
        prm.leave_subsection();
      }
    body_force.add_parameters(prm);
    tank_motion.add_parameters(prm);
    fluid.add_parameters(prm);
    for (auto &material : further_materials)
      material.add_parameters(prm);
    for (auto &body : bodies)
      body.add_parameters(prm);
    seeding.add_parameters(prm);
    point_control.add_parameters(prm);
    formulation.add_parameters(prm);
    quadrature.add_parameters(prm);
    free_surface.add_parameters(prm);
    volume.add_parameters(prm);
    time.add_parameters(prm);
    time_scheme.add_parameters(prm);
    transfer.add_parameters(prm);
    newton.add_parameters(prm);
    linear_solver.add_parameters(prm);
    checkpoint.add_parameters(prm);
    postprocessors.add_parameters(prm);
    prm.enter_subsection("Output");
    prm.add_parameter("Test log",
                      test_log,
                      "Print a compact log without times and machine data, "
                      "also to a file 'output' in the current directory");
    prm.leave_subsection();
  }

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
    for (auto &material : further_materials)
      of_sections.emplace_back([&]() { material.check(input_file); });
    require_all(of_sections);
    check_materials(input_file);
    check_choices(input_file);
    check_scheme(*this);
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
    input_file.require(tank_motion.rotation.empty() || !grid.any_periodic(),
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

  template <int dim>
  std::vector<std::string>
  Scene<dim>::material_names() const
  {
    std::vector<std::string> names;
    for (const MaterialParameters &material : further_materials)
      names.push_back(material.name);
    return names;
  }

  template <int dim>
  std::set<PointColumn>
  Scene<dim>::point_columns() const
  {
    std::set<PointColumn> result = Transfer<dim>::columns(transfer);
    result.merge(CellMaterials<dim>::columns(materials));
    return result;
  }

  template <int dim>
  bool
  Scene<dim>::has_pressure_of_end() const
  {
    return formulation.is_mixed() && !fluid.is_incompressible() &&
           time_scheme.is_elastic_at_end();
  }

  template <int dim>
  VolumeUpdate
  Scene<dim>::volume_update() const
  {
    // points that are the quadrature need volumes of their own: these make up
    // for their disorder (doc/methods.md, volume of the points)
    const VolumeUpdate automatic =
      has_pressure_of_end() && quadrature.has_surface() ?
        VolumeUpdate::from_the_pressure :
      fluid.is_incompressible() || formulation.degree == 2 ?
        VolumeUpdate::nodal_mean :
        VolumeUpdate::at_the_point;
    return volume.value(automatic);
  }

  template <int dim>
  FilledVolume
  Scene<dim>::filled_volume() const
  {
    return fluid.is_incompressible() ? FilledVolume::initial :
                                       FilledVolume::current;
  }

  template <int dim>
  std::vector<std::string>
  Scene<dim>::simulation_columns() const
  {
    std::vector<std::string> names = {"step",
                                      "time [s]",
                                      "dt [s]",
                                      "pressure_time [s]",
                                      "newton_iterations",
                                      "krylov_iterations",
                                      "occupied_cells"};
    if (time.controls_error())
      names.push_back("time_error [cells]");
    const auto account = PointControl<dim>::account_names(point_control);
    names.insert(names.end(), account.begin(), account.end());
    return names;
  }

  template <int dim>
  std::vector<std::string>
  Scene<dim>::summary_numbers() const
  {
    std::vector<std::string> names = {"dim",
                                      "points",
                                      "cells",
                                      "occupied_cells_max",
                                      "work_imbalance",
                                      "points_put_back",
                                      "dofs_max",
                                      "end_time",
                                      "steps",
                                      "rejected_steps",
                                      "newton_iterations",
                                      "krylov_iterations"};
    if (time.controls_error())
      names.push_back("time_error");
    if (time.accepts_failing_steps())
      for (const char *name : AcceptedFailures::summary_numbers)
        names.push_back(name);
    for (const auto &name : PointControl<dim>::account_names(point_control))
      names.push_back("point control/" + name);
    return names;
  }

  template <int dim>
  TankMotion<dim>
  Scene<dim>::make_tank_motion() const
  {
    return {tank_motion, grid, input, time.end_time, time.step};
  }

  template struct Scene<2>;
  template struct Scene<3>;
} // namespace seiche
