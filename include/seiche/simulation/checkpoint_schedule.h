// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_checkpoint_schedule_h
#define seiche_simulation_checkpoint_schedule_h

#include <mpi.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /// prm entries of "Checkpoint".
  struct CheckpointParameters
  {
    unsigned int every_steps     = 0;     ///< 0: none
    double       every_wall_time = 1800.; ///< [s], 0: none

    void
    add_parameters(dealii::ParameterHandler &prm);
  };

  /// What a run does after a step.
  enum class CheckpointRequest : unsigned int
  {
    none,
    write,             ///< and go on
    write_and_restart, ///< and go on from what was written
    write_and_stop     ///< and end
  };

  /**
   * @brief When checkpoints are written: every n steps, every t seconds, on
   * demand by a signal or by a file in the output folder, and before the time
   * of the run is over.
   */
  class CheckpointSchedule
  {
  public:
    /// @p last_moment: when the run has to have ended, in wall_clock() [s].
    CheckpointSchedule(const CheckpointParameters &parameters,
                       const std::string          &directory,
                       const double                last_moment,
                       const MPI_Comm              communicator);

    /// After step number @p step; the same answer on all ranks. Collective.
    CheckpointRequest
    after_step(const unsigned int step);

    /// True if the run is asked to stop; between two tries of a step, which
    /// may take long. Collective.
    bool
    stop_is_wanted();

    /// A checkpoint is written: the next waiting time begins. Local.
    void
    done();

  private:
    /// Of this rank. Local.
    bool
    asked_to_stop();

    /// Whether another step and what follows it might end too late. Local.
    bool
    time_is_up() const;

    const CheckpointParameters parameters;
    const std::string          write_file, stop_file;
    const MPI_Comm             communicator;
    const bool                 is_first_rank;
    const double               last_moment; ///< [s] wall clock, as those below
    double                     last_time;   ///< of a checkpoint
    double                     step_begin;
    double                     longest_step = 0., longest_checkpoint = 0.;
    bool                       stop_file_was_seen = false;
  };
} // namespace seiche

#endif
