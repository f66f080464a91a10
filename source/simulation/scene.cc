// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/accepted_failures.h>
#include <seiche/simulation/scene.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Scene<dim>::Scene(const InputFile &input_file)
    : input(input_file)
    , grid(input_file)
    , postprocessors(input_file)
  {
    for (const std::string &name : input.instances("Fluid body"))
      {
        bodies.emplace_back(name);
      }
    for (const std::string &name : input.instances(MaterialParameters::kind))
      {
        further_materials.emplace_back();
        further_materials.back().name = name;
      }
    for (const std::string &name : input.instances(ShapeParameters<dim>::kind))
      shapes.emplace_back(ShapeParameters<dim>::subsection_of(name));
    for (const std::string &name : input.instances(SolidParameters<dim>::kind))
      solids.emplace_back(name);
    for (const std::string &name :
         input.instances(MooringParameters<dim>::kind))
      moorings.emplace_back(name);
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
    for (auto &shape : shapes)
      shape.add_subsection(prm);
    for (auto &solid : solids)
      solid.add_parameters(prm);
    for (auto &mooring : moorings)
      mooring.add_parameters(prm);
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
    const auto add_columns = [&](const RigidMotionParameters<dim> &motion,
                                 const std::string                &name) {
      for (const auto direction : motion.body.directions(input))
        for (const std::string &column : direction.columns(name))
          names.push_back(column);
    };
    add_columns(tank_motion, "tank");
    for (const auto &solid : solids)
      if (solid.motion.any())
        {
          names.push_back("work of " + solid.name + " [J]");
          for (unsigned int d = 0; d < BodyDirection<dim>::n_all; ++d)
            names.push_back(BodyDirection<dim>{d}.column_of_place(solid.name));
          add_columns(solid.motion, solid.name);
          for (const auto direction : solid.motion.body.directions(input))
            names.push_back(direction.column_of_stop(solid.name));
          for (const auto &mooring : moorings)
            if (mooring.solid == solid.name)
              for (const auto &column : Mooring<dim>::columns(mooring.name))
                names.push_back(column);
        }
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
