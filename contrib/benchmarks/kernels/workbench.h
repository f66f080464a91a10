// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef contrib_benchmarks_kernels_workbench_h
#define contrib_benchmarks_kernels_workbench_h

#include <seiche/grid/wall_conditions.h>
#include <seiche/postprocess/postprocessor.h>
#include <seiche/simulation/planned_scene.h>
#include <seiche/solve/assembler.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

/**
 * @brief A scene at its start, as Simulation sets it up, with its objects in
 * the open: what a kernel needs to be called again and again.
 */
template <int dim>
struct Workbench
{
  using Vector      = typename seiche::GridState<dim>::Vector;
  using BlockVector = typename seiche::GridState<dim>::BlockVector;

  Workbench(const std::string              &filename,
            const std::vector<std::string> &overrides)
    : input(filename, overrides)
    , planned(input, MPI_COMM_WORLD)
    , scene(planned.scene)
    , grid(scene.grid, MPI_COMM_WORLD)
    , locator(grid)
    , time_scheme(
        seiche::make_time_scheme<dim>(scene.time_scheme,
                                      scene.fluid.is_incompressible()))
    , formulation(seiche::make_formulation<dim>(scene.formulation,
                                                scene.fluid.volume_law))
    , points(locator, scene.point_columns(), MPI_COMM_WORLD)
    , occupancy(locator, scene.formulation.degree)
    , fill(occupancy, scene.quadrature.value(), scene.filled_volume())
    , materials(scene.materials, occupancy)
    , quadrature(seiche::make_quadrature(points,
                                         fill,
                                         materials,
                                         seiche::VolumeRatio::one))
    , tank_motion(scene.make_tank_motion())
    , body_force(scene.body_force, tank_motion, scene.input)
    , wall_motion(scene.grid, scene.input, scene.time.end_time)
    , wall_velocity(scene.grid, scene.input, scene.time.end_time)
    , wall_conditions(wall_velocity, wall_motion, occupancy)
    , transfer(scene.transfer, fill, materials, scene.volume_update())
    , matrix(occupancy, formulation->has_pressure())
    , assembler({*formulation, materials, body_force, scene.free_surface},
                *quadrature,
                fill,
                timer)
  {
    seiche::seed_bodies(
      scene.seeding, planned.bodies, scene.input, scene.materials, points);
    occupancy.update(points);
    fill.update(points);
    materials.update(points);
    matrix.reinit(fill);
    state.reinit(occupancy, formulation->has_pressure(), false);
    state.dt = scene.time.step;
    inertia_offset.reinit(occupancy.vector_partitioner());
    rate_offset.reinit(occupancy.vector_partitioner());
    transfer.points_to_grid(points, state);
    wall_conditions.set_start_velocity(state);
    time_scheme->predict(state);
    time_scheme->offsets(state, state.dt, inertia_offset, rate_offset);
    const seiche::StepCoefficients step = time_scheme->coefficients(state.dt);
    wall_conditions.set_displacement(state, step, rate_offset);
    assembler.begin(step, state, inertia_offset, rate_offset);
    residual.reinit(state.solution);
    solution.reinit(state.solution);
    assembler.residual(state, residual);
    assembler.tangent(state, matrix);
  }

  /// What postprocessors see of it.
  seiche::StepView<dim>
  view() const
  {
    seiche::StepView<dim> result(points, fill, state);
    result.bulk_modulus = scene.fluid.volume_law.bulk_modulus;
    result.theta = result.pressure_theta = 0.5;
    return result;
  }

  const seiche::InputFile                         input;
  const seiche::PlannedScene<dim>                 planned;
  const seiche::Scene<dim>                       &scene;
  seiche::TimerTree                               timer;
  seiche::BackgroundGrid<dim>                     grid;
  seiche::CellLocator<dim>                        locator;
  const std::unique_ptr<seiche::TimeScheme<dim>>  time_scheme;
  const std::unique_ptr<seiche::Formulation<dim>> formulation;
  seiche::PointCloud<dim>                         points;
  seiche::Occupancy<dim>                          occupancy;
  seiche::Fill<dim>                               fill;
  seiche::CellMaterials<dim>                      materials;
  const std::unique_ptr<seiche::Quadrature<dim>>  quadrature;
  const seiche::TankMotion<dim>                   tank_motion;
  const seiche::BodyForce<dim>                    body_force;
  const seiche::WallMotion<dim>                   wall_motion;
  const seiche::WallVelocity<dim>                 wall_velocity;
  const seiche::WallConditions<dim>               wall_conditions;
  const seiche::Transfer<dim>                     transfer;
  seiche::BlockMatrix<dim>                        matrix;
  seiche::Assembler<dim>                          assembler;
  seiche::GridState<dim>                          state;
  Vector                                          inertia_offset, rate_offset;
  BlockVector                                     residual, solution;
};

#endif
