// SPDX-License-Identifier: LGPL-2.1-or-later
// What becomes of a step that fails: it is repeated with a smaller size, or the
// run ends, with advice and a frame that shows where it stood.
#include <seiche/postprocess/grid_output.h>
#include <seiche/postprocess/nodal_pressure.h>
#include <seiche/postprocess/point_output.h>
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/step_failure.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/result_names.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Where the frame of a failure goes: made here. Collective.
    FrameSettings
    failure_folder(const std::string &directory, const MPI_Comm communicator)
    {
      const FrameSettings settings{directory + "/" + result_names::failure,
                                   /*interval=*/1.,
                                   /*end_time=*/0.};
      on_first_rank(communicator, [&]() {
        checked_file::make_directory(settings.directory);
      });
      return settings;
    }

    /// Why the attempt has failed; empty: it has not.
    std::string
    failure_of(const std::function<void()> &attempt)
    {
      try
        {
          attempt();
          return "";
        }
      catch (const StepFailure &failure)
        {
          return failure.what();
        }
    }
  } // namespace

  template <int dim>
  bool
  Simulation<dim>::repeat_until_accepted(
    const std::function<void()> &attempt,
    const std::function<bool()> &stop_is_wanted)
  {
    try
      {
        while (true)
          {
            const std::string failure = failure_of(attempt);
            count_iterations();
            if (!failure.empty())
              {
                report.warn("a step was repeated with half its size",
                            fmt::format("t = {:.6g} s: {}",
                                        state.time,
                                        failure));
                state.dt = time_stepper.repeat(failure);
                if (stop_is_wanted())
                  return false;
                continue;
              }
            record.error =
              step_solver.local_error(state, time_stepper.previous_step());
            const ErrorVerdict verdict = time_stepper.judge(record.error);
            if (verdict == ErrorVerdict::too_large)
              {
                state.dt = time_stepper.repeat_for_error(record.error);
                continue;
              }
            if (verdict == ErrorVerdict::accepted_at_least_size)
              report.warn("the error of a step exceeds Time/Error tolerance at "
                          "the smallest size it is cut to",
                          fmt::format("t = {:.6g} s, {:.3g} s",
                                      state.time,
                                      state.dt));
            return true;
          }
      }
    catch (const NumericalError &) // on all ranks
      {
        write_failure();
        throw;
      }
  }

  template <int dim>
  void
  Simulation<dim>::count_iterations()
  {
    const NewtonResult &newton = step_solver.newton_result();
    record.newton += newton.iterations;
    record.krylov += newton.krylov_iterations;
    newton_total += newton.iterations;
    krylov_total += newton.krylov_iterations;
  }

  template <int dim>
  void
  Simulation<dim>::locate_points()
  {
    const TimerTree::Scope scope(timer, "locate");
    problem.move_grid(time_stepper.time());
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
  void
  Simulation<dim>::write_failed_points()
  {
    PointOutput<dim>(failure_folder(directory, communicator), communicator)
      .execute(step_view(/*dt=*/0.), statistics);
  }

  template <int dim>
  void
  Simulation<dim>::write_failure()
  {
    state.velocity_np1 = state.velocity_n; // nothing has moved
    state.velocity_np1.update_ghost_values();
    state.solution = 0.;
    if (state.has_pressure())
      state.pressure() = state.pressure_guess;
    state.solution.update_ghost_values();
    const StepView<dim> before = step_view(/*dt=*/0.);
    GridOutput<dim>(failure_folder(directory, communicator),
                    std::make_shared<NodalPressure<dim>>(),
                    communicator)
      .execute(before, statistics);
    write_failed_points();
  }


  template bool
  Simulation<2>::repeat_until_accepted(const std::function<void()> &,
                                       const std::function<bool()> &);
  template bool
  Simulation<3>::repeat_until_accepted(const std::function<void()> &,
                                       const std::function<bool()> &);
  template void
  Simulation<2>::locate_points();
  template void
  Simulation<3>::locate_points();
} // namespace seiche
