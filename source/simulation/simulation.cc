// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/simulation.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of the largest way of a point in a step, what a wall may move: the grid
    /// goes with it, and the sum of both counts.
    constexpr double largest_wall_way = 0.5;

    /// Relative change of a full box in a step that is round-off.
    constexpr double largest_volume_change = 1e-10;
  } // namespace

  template <int dim>
  Simulation<dim>::Simulation(Scene<dim>        &run_scene,
                              const std::string &output_directory,
                              RunReport         &run_report,
                              TimerTree         &run_timer,
                              const Checkpoint  *checkpoint)
    : scene(run_scene)
    , directory(output_directory)
    , communicator(MPI_COMM_WORLD)
    , report(run_report)
    , timer(run_timer)
    , start(checkpoint)
    , wall_motion(scene.grid, scene.input, scene.time.end_time)
    , grid(scene.grid, communicator)
    , locator(grid)
    , time_scheme(make_time_scheme<dim>(scene.time_scheme))
    , formulation(make_formulation<dim>(scene.formulation, scene.material()))
    , points(locator, point_columns(), communicator)
    , seeding(fill_points(start))
    , mesh_adaptation(grid,
                      locator,
                      points,
                      scene.quadrature.gauss_in_full_cells())
    , occupancy(locator, scene.formulation.degree)
    , fill(occupancy, scene.quadrature.gauss_in_full_cells())
    , point_control(scene.point_control, points, occupancy, fill)
    , quadrature(make_quadrature(scene.quadrature,
                                 points,
                                 fill,
                                 scene.fluid.density,
                                 formulation->has_pressure() &&
                                   std::isinf(scene.fluid.bulk_modulus)))
    , body_force(scene.body_force, scene.input)
    , wall_velocity(scene.grid, scene.input)
    , wall_conditions(wall_velocity, wall_motion, occupancy)
    , wall_contact(wall_conditions,
                   occupancy,
                   body_force,
                   scene.fluid.density,
                   formulation->has_pressure() &&
                     std::isinf(scene.fluid.bulk_modulus))
    , transfer(scene.transfer,
               fill,
               scene.fluid.density,
               scene.uses_mean_volume())
    , matrix(occupancy, formulation->has_pressure())
    , assembler(*formulation,
                *quadrature,
                fill,
                body_force,
                scene.free_surface,
                timer)
    , linear_solver(scene.linear_solver, scene.material(), timer)
    , velocity_projection(assembler,
                          matrix,
                          linear_solver,
                          scene.linear_solver.projection_tolerance)
    , residual_projection(assembler, *quadrature, occupancy)
    , newton(scene.newton,
             scene.linear_solver.tolerance,
             assembler,
             residual_projection,
             matrix,
             linear_solver,
             wall_contact)
    , time_stepper(scene.time)
    , statistics(directory + "/statistics.csv",
                 Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    scene.postprocessors.check(grid);
  }

  template <int dim>
  RunOutcome
  Simulation<dim>::run(CheckpointSchedule &schedule, CheckpointFolder &folder)
  {
    begin();
    while (!time_stepper.finished())
      {
        const bool done = step(schedule);
        if (done)
          postprocess();
        const CheckpointRequest request =
          done ? schedule.after_step(time_stepper.steps()) :
                 CheckpointRequest::write_and_stop;
        if (request == CheckpointRequest::none)
          continue;
        write_checkpoint(folder);
        schedule.done();
        if (time_stepper.finished())
          break;
        if (request == CheckpointRequest::write_and_restart)
          return RunOutcome::restart;
        if (request == CheckpointRequest::write_and_stop)
          return RunOutcome::stopped;
      }
    finish();
    return RunOutcome::finished;
  }

  template <int dim>
  bool
  Simulation<dim>::step(CheckpointSchedule &schedule)
  {
    const TimerTree::Scope scope(timer, "step");
    if (!material_is_found)
      find_material();
    state.time = time_stepper.time();
    state.dt   = time_stepper.next_step(speed_per_cell());
    while (true)
      {
        const std::string failure = try_step();
        if (failure.empty())
          break;
        report.warn("a step was repeated with half its size",
                    fmt::format("t = {:.6g} s: {}", state.time, failure));
        state.dt = time_stepper.repeat(failure);
        if (schedule.stop_is_wanted())
          return false;
      }
    {
      const TimerTree::Scope scope_back(timer, "grid to points");
      transfer.grid_to_points(state, points);
      formulation->update_points(points);
    }
    time_stepper.accept();
    material_is_found = points_are_controlled = false;
    newton_total += last.iterations;
    krylov_total += last.krylov_iterations;
    return true;
  }

  template <int dim>
  void
  Simulation<dim>::find_material()
  {
    {
      const TimerTree::Scope scope(timer, "locate");
      move_grid();
      points.locate();
    }
    {
      const TimerTree::Scope scope(timer, "mesh adaptation");
      if (time_stepper.steps() > 0 &&
          mesh_adaptation.update(time_stepper.steps()))
        occupancy.reinit();
    }
    if (points.n_global() == 0)
      throw NumericalError(
        fmt::format("t = {:.6g} s: all fluid has left through open sides; set "
                    "a smaller Time/End time",
                    time_stepper.time()));
    {
      const TimerTree::Scope scope(timer, "occupancy and fill");
      occupancy.update(points);
      fill.update(points);
    }
    if (time_stepper.steps() > 0 && !points_are_controlled)
      {
        const TimerTree::Scope scope(timer, "point control");
        point_control.update();
        points_are_controlled = true;
      }
    {
      const TimerTree::Scope scope(timer, "pattern");
      matrix.reinit(fill);
    }
    const TimerTree::Scope scope(timer, "points to grid");
    state.reinit(occupancy,
                 formulation->has_pressure(),
                 time_scheme->needs_acceleration());
    inertia_offset.reinit(occupancy.vector_partitioner());
    rate_offset.reinit(occupancy.vector_partitioner());
    transfer.points_to_grid(points, state);
    material_is_found = true;
    occupied_max = std::max(occupied_max, occupancy.n_global_occupied_cells());
    unknowns_max =
      std::max<std::uint64_t>(unknowns_max,
                              occupancy.n_global_nodes() *
                                (dim + formulation->has_pressure()));
  }

  template <int dim>
  std::string
  Simulation<dim>::try_step()
  {
    last             = NewtonResult();
    const double way = wall_way(state.dt);
    if (way > largest_wall_way * scene.time.maximum_displacement)
      return fmt::format("a wall moves by {:.3g} cells", way);
    if (assembler.is_closed() &&
        std::abs(wall_motion.volume_change(state.time, state.dt)) >
          largest_volume_change)
      throw NumericalError(fmt::format(
        "t = {:.6g} s: walls change the volume of a box that is full of "
        "incompressible fluid. Leave room above the fluid, open a wall or set "
        "a finite Fluid/Bulk modulus.",
        state.time));
    linear_solver.begin_step();
    if (const std::string failure = find_start_velocity(); !failure.empty())
      return failure;
    {
      const TimerTree::Scope scope(timer, "newton");
      time_scheme->predict(state);
      time_scheme->offsets(state, state.dt, inertia_offset, rate_offset);
      const StepCoefficients coefficients = step_coefficients();
      wall_conditions.set_displacement(state, coefficients, rate_offset);
      wall_contact.begin_iteration(coefficients, rate_offset);
      assembler.begin(coefficients, state.time, inertia_offset, rate_offset);
      const NewtonResult result = newton.solve(state);
      last.iterations           = result.iterations;
      last.krylov_iterations += result.krylov_iterations;
      if (!result.converged)
        return result.failure;
    }
    const TimerTree::Scope scope(timer, "acceptance");
    time_scheme->finish(state);
    return transfer.check(state, points)
      .problem(scene.time.maximum_displacement - way);
  }

  template <int dim>
  std::string
  Simulation<dim>::find_start_velocity()
  {
    wall_contact.begin(state);
    wall_conditions.set_start_velocity(state);
    if (!formulation->has_pressure() ||
        !(scene.time.projects_each_step() || time_stepper.steps() == 0))
      return "";
    const TimerTree::Scope scope(timer, "velocity projection");
    while (true)
      {
        const LinearResult result =
          velocity_projection.apply(state,
                                    step_coefficients(),
                                    wall_contact.any());
        last.krylov_iterations += result.iterations;
        if (!result.is_usable(VelocityProjection<dim>::usable_reduction))
          return "the velocity projection did not converge";
        if (!result.converged)
          report.warn("a velocity projection stopped early",
                      fmt::format("t = {:.6g} s: {:.1e} of the violation is "
                                  "left",
                                  state.time,
                                  result.reduction));
        if (!wall_contact.correct_start(state))
          return "";
        wall_conditions.set_start_velocity(state);
      }
  }

  template <int dim>
  StepCoefficients
  Simulation<dim>::step_coefficients() const
  {
    StepCoefficients result = time_scheme->coefficients(state.dt);
    // a smaller step after a failure must ask for less, or it fails as well
    result.volume_recovery =
      scene.volume_relaxation_time > 0. ?
        std::min(1., state.dt / scene.volume_relaxation_time) :
        time_stepper.share();
    return result;
  }

  template <int dim>
  double
  Simulation<dim>::speed_per_cell() const
  {
    double largest = 0.;
    for (std::size_t p = 0; p < points.size(); ++p)
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max(largest,
                           std::abs(points.data(PointColumn::velocity, d)[p]) /
                             locator.reach(points.cells()[p])[d]);
    largest = std::max(largest, wall_way(scene.time.step) / scene.time.step);
    return Utilities::MPI::max(largest, communicator);
  }

  template <int dim>
  double
  Simulation<dim>::wall_way(const double dt) const
  {
    return wall_motion.largest_way(time_stepper.time(), dt) /
           occupancy.smallest_extent();
  }

  template <int dim>
  void
  Simulation<dim>::move_grid()
  {
    if (!wall_motion.any())
      return;
    const double time = time_stepper.time();
    locator.move(
      [this, time](const unsigned int direction, const double place) {
        return wall_motion.line(direction, place, time);
      });
    occupancy.update_places();
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace seiche
