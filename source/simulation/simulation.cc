// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/step_advice.h>
#include <seiche/solve/displacement_error.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/injected_fault.h>
#include <seiche/utilities/result_names.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// What tests of the answer to it ask for.
    template <int dim>
    void
    damage_if_asked(PointCloud<dim> &points)
    {
      if (points.size() == 0)
        return;
      if (is_injected(Fault::position))
        points.data(PointColumn::position)[0] =
          std::numeric_limits<double>::quiet_NaN();
      if (is_injected(Fault::velocity))
        points.data(PointColumn::velocity)[0] =
          std::numeric_limits<double>::quiet_NaN();
      if (is_injected(Fault::speed))
        points.data(PointColumn::velocity)[0] = 1e150;
    }
  } // namespace

  template <int dim>
  Simulation<dim>::Simulation(PlannedScene<dim> &planned,
                              const std::string &output_directory,
                              RunReport         &run_report,
                              TimerTree         &run_timer,
                              std::unique_ptr<const Checkpoint> checkpoint)
    : scene(planned.scene)
    , directory(output_directory)
    , communicator(MPI_COMM_WORLD)
    , report(run_report)
    , timer(run_timer)
    , start(std::move(checkpoint))
    , problem(planned, timer, start.get(), communicator)
    , step_solver(problem, report, timer)
    , time_stepper(scene.time, step_advice(scene, planned.plan.scales))
    , chamber_notices(scene, report)
    , expected_step(planned.plan.scales.expected_step())
    , statistics(directory + "/" + result_names::statistics,
                 Utilities::MPI::this_mpi_process(communicator) == 0)
  {}

  template <int dim>
  RunOutcome
  Simulation<dim>::run(CheckpointSchedule   &schedule,
                       CheckpointFolder     &folder,
                       const EarlierResults &earlier)
  {
    begin();
    bool is_first_step = true;
    while (!finished())
      {
        const bool done = advance([&]() { return schedule.stop_is_wanted(); });
        if (done && is_first_step)
          on_first_rank(communicator, [&]() { earlier.remove_older(); });
        is_first_step = is_first_step && !done;
        if (is_empty)
          break;
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
  Simulation<dim>::advance(const std::function<bool()> &stop_is_wanted)
  {
    const bool done = step(stop_is_wanted);
    if (done && !is_empty)
      postprocess();
    return done;
  }

  template <int dim>
  template <typename Attempt>
  auto
  Simulation<dim>::keeping_evidence(const Attempt &attempt)
  {
    try
      {
        return attempt();
      }
    catch (const NumericalError &) // on all ranks
      {
        write_failure();
        throw;
      }
  }

  template <int dim>
  bool
  Simulation<dim>::step(const std::function<bool()> &stop_is_wanted)
  {
    const TimerTree::Scope scope(timer, "step");
    if (!material_is_found && !find_material())
      {
        is_empty = true;
        return true;
      }
    state.time = time_stepper.time();
    effort     = {};
    double speed, error; // [1/s], [cells]
    {
      const TimerTree::Scope scope_size(timer, "step size");
      speed    = speed_per_cell();
      state.dt = time_stepper.next_step(speed);
    }
    chamber_notices.update(problem.fill.closed_chambers(), state.time);
    while (true)
      {
        const std::string failure =
          keeping_evidence([&]() { return try_step(); });
        if (failure.empty())
          {
            error                      = step_error();
            const ErrorVerdict verdict = time_stepper.judge(error);
            if (verdict == ErrorVerdict::too_large)
              {
                state.dt = time_stepper.repeat_for_error(error);
                continue;
              }
            if (verdict == ErrorVerdict::accepted_at_least_size)
              report.warn("the error of a step exceeds Time/Error tolerance at "
                          "the smallest size it is cut to",
                          fmt::format("t = {:.6g} s, {:.3g} s",
                                      state.time,
                                      state.dt));
            break;
          }
        halve_step(failure);
        if (stop_is_wanted())
          return false;
      }
    if (problem.tank_motion.any())
      balance = problem.assembler.balance(state);
    {
      const TimerTree::Scope scope_back(timer, "grid to points");
      move_points(speed);
    }
    time_stepper.accept(error);
    material_is_found = points_are_controlled = false;
    return true;
  }

  template <int dim>
  void
  Simulation<dim>::halve_step(const std::string &failure)
  {
    report.warn("a step was repeated with half its size",
                fmt::format("t = {:.6g} s: {}", state.time, failure));
    state.dt = keeping_evidence([&]() { return time_stepper.repeat(failure); });
  }

  template <int dim>
  void
  Simulation<dim>::locate_points()
  {
    try
      {
        problem.points.locate();
      }
    catch (const NumericalError &error) // on all ranks
      {
        write_failed_points();
        throw NumericalError(fmt::format("t = {:.6g} s: {} {}",
                                         time_stepper.time(),
                                         error.what(),
                                         time_stepper.what_may_help()));
      }
  }

  template <int dim>
  bool
  Simulation<dim>::find_material()
  {
    {
      const TimerTree::Scope scope(timer, "locate");
      problem.move_grid(time_stepper.time());
      locate_points();
    }
    {
      const TimerTree::Scope scope(timer, "mesh adaptation");
      if (time_stepper.steps() > 0 &&
          problem.mesh_adaptation.update(time_stepper.steps()))
        problem.occupancy.reinit();
    }
    if (problem.points.n_global() == 0)
      return false;
    {
      const TimerTree::Scope scope(timer, "occupancy and fill");
      problem.find_cells();
    }
    if (time_stepper.steps() > 0 && !points_are_controlled)
      {
        const TimerTree::Scope scope(timer, "point control");
        problem.point_control.update();
        points_are_controlled = true;
      }
    {
      const TimerTree::Scope scope(timer, "pattern");
      problem.find_unknowns();
    }
    const TimerTree::Scope scope(timer, "points to grid");
    problem.points_to_grid(state);
    material_is_found = true;
    occupied_max =
      std::max(occupied_max, problem.occupancy.n_global_occupied_cells());
    unknowns_max =
      std::max<std::uint64_t>(unknowns_max,
                              problem.occupancy.n_global_nodes() *
                                (dim + problem.formulation->has_pressure()));
    return true;
  }

  template <int dim>
  std::string
  Simulation<dim>::try_step()
  {
    const bool projects =
      scene.time.projects_each_step() || time_stepper.steps() == 0;
    const std::string failure =
      step_solver.solve(state, projects, time_stepper.is_repeated());
    effort.newton += step_solver.effort().iterations;
    effort.krylov += step_solver.effort().krylov_iterations;
    newton_total += step_solver.effort().iterations;
    krylov_total += step_solver.effort().krylov_iterations;
    if (!failure.empty())
      return failure;
    const TimerTree::Scope scope(timer, "acceptance");
    const double           limit = largest_way();
    return problem.transfer.check(state, problem.points, limit)
      .problem(limit, scene.time.accepts_failing_steps());
  }

  template <int dim>
  double
  Simulation<dim>::largest_way() const
  {
    return scene.time.maximum_displacement -
           problem.wall_way(state.time, state.dt);
  }

  template <int dim>
  void
  Simulation<dim>::move_points(const double speed_per_cell)
  {
    const bool        accepts = scene.time.accepts_failing_steps();
    const std::size_t n_held  = problem.transfer.grid_to_points(
      state,
      problem.points,
      accepts ? largest_way() : std::numeric_limits<double>::infinity());
    problem.formulation->update_points(problem.points,
                                       scene.volume_update() ==
                                         VolumeUpdate::from_the_pressure);
    if (problem.fill.has_surface())
      {
        const TimerTree::Scope scope(timer, "density projection");
        problem.density_projection.apply(
          std::max(speed_per_cell, step_solver.fall_rate()) * state.dt,
          problem.wall_motion.box(state.time + state.dt),
          problem.points);
      }
    problem.points.wrap();
    damage_if_asked(problem.points);
    if (accepts)
      accepted_failures.account(
        step_solver.effort(), n_held, state.time, communicator, report);
  }

  template <int dim>
  double
  Simulation<dim>::step_error() const
  {
    if (!scene.time.controls_error() || time_stepper.previous_step() == 0.)
      return 0.;
    const double lag = problem.time_scheme->pressure_time();
    return displacement_error(state,
                              problem.time_scheme->error_constant(),
                              lag * state.dt +
                                (1. - lag) * time_stepper.previous_step()) /
           problem.occupancy.smallest_extent();
  }

  template <int dim>
  double
  Simulation<dim>::speed_per_cell() const
  {
    double largest = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double *velocity = problem.points.data(PointColumn::velocity, d);
        for (const unsigned int cell : problem.occupancy.occupied_cells())
          {
            double speed = 0.;
            for (const std::size_t p : problem.points.points_in(cell))
              speed = std::max(speed, std::abs(velocity[p]));
            largest = std::max(largest, speed / problem.locator.reach(cell)[d]);
          }
      }
    // now and over a step, which may take a wall there and back
    for (const double dt : {1e-3 * scene.time.step, scene.time.step})
      largest =
        std::max(largest, problem.wall_way(time_stepper.time(), dt) / dt);
    return Utilities::MPI::max(largest, communicator);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace seiche
