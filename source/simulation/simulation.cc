// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/speed_per_cell.h>
#include <seiche/simulation/step_advice.h>
#include <seiche/simulation/step_failure.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/injected_fault.h>
#include <seiche/utilities/result_names.h>

#include <limits>

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
    {
      const TimerTree::Scope scope(timer, "step");

      // initialization: the points give the grid all that it has
      if (!is_on_grid) // begin() has done it for the first step
        {
          locate_points();
          problem.adapt_mesh(time_stepper.steps());
          if (problem.points.n_global() == 0)
            {
              is_empty = true;
              return true;
            }
          problem.find_cells();
          control_points();
          points_to_grid();
        }
      begin_step();

      // calculation: the grid moves as the fluid does
      const auto attempt = [&]() {
        step_solver.begin(state);
        step_solver.find_start_velocity(state, start_is_projected());
        {
          const TimerTree::Scope scope_newton(timer, "newton");
          step_solver.predict(state);
          step_solver.solve(state, time_stepper.is_repeated());
        }
        problem.time_scheme->finish(state);
        check_step();
      };
      if (!repeat_until_accepted(attempt, stop_is_wanted))
        return false;
      if (problem.tank_motion.any())
        balance = problem.assembler.balance(state);
      add_work_of_solids();

      // convection: the points move with the grid
      {
        const TimerTree::Scope scope_back(timer, "grid to points");
        grid_to_points();
        problem.update_points();
        if (problem.fill.has_surface())
          project_density();
        problem.points.wrap();
        damage_if_asked(problem.points);
      }
      time_stepper.accept(record.error);
      if (problem.bodies != nullptr)
        problem.bodies->accept();
      is_on_grid = points_are_controlled = false;
    }
    postprocess();
    return true;
  }

  template <int dim>
  void
  Simulation<dim>::add_work_of_solids()
  {
    if (!any_moves(problem.locator.solids))
      return;
    std::vector<double> work(problem.locator.solids.size(), 0.);
    state.for_each_solid_reaction([&](const SolidReaction<dim> &reaction) {
      work[reaction.solid] += reaction.work;
    });
    Utilities::MPI::sum(work, communicator, work);
    work_of_solids.resize(work.size());
    for (unsigned int s = 0; s < work.size(); ++s)
      work_of_solids[s] += work[s];
  }

  template <int dim>
  void
  Simulation<dim>::control_points()
  {
    if (time_stepper.steps() == 0 || points_are_controlled)
      return;
    const TimerTree::Scope scope(timer, "point control");
    problem.point_control.update();
    points_are_controlled = true;
  }

  template <int dim>
  void
  Simulation<dim>::points_to_grid()
  {
    problem.find_unknowns();
    problem.points_to_grid(state);
    is_on_grid                      = true;
    const Occupancy<dim> &occupancy = problem.occupancy;
    occupied_max = std::max(occupied_max, occupancy.cells.n_global());
    unknowns_max =
      std::max<std::uint64_t>(unknowns_max,
                              occupancy.nodes.n_global() *
                                (dim + problem.formulation.has_pressure()));
  }

  template <int dim>
  void
  Simulation<dim>::begin_step()
  {
    record     = {};
    state.time = time_stepper.time();
    {
      const TimerTree::Scope scope(timer, "step size");
      record.speed = speed_per_cell(problem, state.time);
      state.dt     = time_stepper.next_step(record.speed);
    }
    chamber_notices.update(problem.fill.closed_chambers(), state.time);
  }

  template <int dim>
  bool
  Simulation<dim>::start_is_projected() const
  {
    return scene.time.projects_each_step() || time_stepper.steps() == 0;
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
  Simulation<dim>::check_step()
  {
    const TimerTree::Scope scope(timer, "acceptance");
    const double           limit = largest_way();
    const std::string      failure =
      problem.transfer.check(state, problem.points, limit)
        .problem(limit, scene.time.accepts_failing_steps());
    if (!failure.empty())
      throw StepFailure(failure);
  }

  template <int dim>
  void
  Simulation<dim>::grid_to_points()
  {
    const bool   accepts = scene.time.accepts_failing_steps();
    const double limit =
      accepts ? largest_way() : std::numeric_limits<double>::infinity();
    const std::size_t n_held =
      problem.transfer.grid_to_points(state, problem.points, limit);
    if (accepts)
      accepted_failures.account(
        step_solver.newton_result(), n_held, state.time, communicator, report);
  }

  template <int dim>
  void
  Simulation<dim>::project_density()
  {
    const TimerTree::Scope scope(timer, "density projection");
    const double rate = std::max(record.speed, step_solver.fall_rate());
    problem.density_projection.apply(rate * state.dt,
                                     problem.grid_motion.box(state.time +
                                                             state.dt),
                                     problem.points);
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace seiche
