// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/checkpoint_schedule.h>
#include <seiche/utilities/stop_signal.h>
#include <seiche/utilities/timer_tree.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cstdio>

namespace seiche
{
  namespace
  {
    /// True if the file (or empty folder) is there; it is removed then. (At
    /// once, not when what it asks for is done: another may be made in
    /// between.)
    bool
    take(const std::string &filename)
    {
      return std::remove(filename.c_str()) == 0;
    }
  } // namespace



  void
  CheckpointParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Checkpoint");
    prm.add_parameter("Every steps",
                      every_steps,
                      "Steps between two checkpoints, after each of which the "
                      "run goes on exactly as a restart from it would; 0: none",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Every wall time",
                      every_wall_time,
                      "Wall time between two checkpoints, which do not alter "
                      "the run; 0: none [s]",
                      dealii::Patterns::Double(0.));
    prm.leave_subsection();
  }



  CheckpointSchedule::CheckpointSchedule(const CheckpointParameters &p,
                                         const std::string          &directory,
                                         const double                end_of_run,
                                         const MPI_Comm mpi_communicator)
    : parameters(p)
    , write_file(directory + "/checkpoint-now")
    , stop_file(directory + "/stop")
    , communicator(mpi_communicator)
    , is_first_rank(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
    , last_moment(end_of_run)
    , last_time(wall_clock())
    , step_begin(last_time)
  {
    if (is_first_rank)
      for (const std::string &filename : {write_file, stop_file})
        take(filename);
  }



  CheckpointRequest
  CheckpointSchedule::after_step(const unsigned int step)
  {
    longest_step = std::max(longest_step, wall_clock() - step_begin);
    step_begin   = wall_clock();
    CheckpointRequest request  = CheckpointRequest::none;
    const bool        is_asked = is_first_rank && take(write_file);
    if (parameters.every_steps > 0 && step % parameters.every_steps == 0)
      request = CheckpointRequest::write_and_restart;
    else if (is_asked ||
             (is_first_rank && parameters.every_wall_time > 0. &&
              wall_clock() - last_time >= parameters.every_wall_time))
      request = CheckpointRequest::write;
    if (asked_to_stop())
      request = CheckpointRequest::write_and_stop;
    return static_cast<CheckpointRequest>(
      dealii::Utilities::MPI::max(static_cast<unsigned int>(request),
                                  communicator));
  }



  bool
  CheckpointSchedule::stop_is_wanted()
  {
    return dealii::Utilities::MPI::max(asked_to_stop() ? 1 : 0, communicator) ==
           1;
  }



  bool
  CheckpointSchedule::asked_to_stop()
  {
    stop_file_was_seen =
      stop_file_was_seen || (is_first_rank && take(stop_file));
    // a signal may have reached one rank only
    return stop_signal::received() || stop_file_was_seen ||
           (is_first_rank && time_is_up());
  }



  bool
  CheckpointSchedule::time_is_up() const
  {
    // the next step and checkpoint may take twice as long as any before
    return wall_clock() + 2. * (longest_step + longest_checkpoint) >
           last_moment;
  }



  void
  CheckpointSchedule::done()
  {
    last_time          = wall_clock();
    longest_checkpoint = std::max(longest_checkpoint, last_time - step_begin);
    step_begin         = last_time;
  }
} // namespace seiche
