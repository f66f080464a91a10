// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_simulation_h
#define seiche_simulation_simulation_h

#include <seiche/simulation/accepted_failures.h>
#include <seiche/simulation/chamber_notices.h>
#include <seiche/simulation/checkpoint_folder.h>
#include <seiche/simulation/earlier_results.h>
#include <seiche/simulation/problem.h>
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/step_solver.h>
#include <seiche/utilities/timer_tree.h>

#include <functional>
#include <string>

namespace seiche
{
  /// Why Simulation::run() has returned.
  enum class RunOutcome
  {
    finished, ///< the end time is reached
    restart,  ///< go on with a new Simulation from the last checkpoint
    stopped   ///< asked to; the last checkpoint is that of the last step
  };

  /**
   * @brief One run: owns the objects of the method and calls them in order.
   *
   * A step of the implicit material point method (Sulsky 1994; founding
   * paper, section 5): locate the points and find the occupied cells;
   * points to grid; Newton for the displacement (and pressure) of the grid;
   * grid to points. The grid carries nothing from step to step. Points are
   * written only after Newton has converged and the step is accepted, so a
   * rejected step costs nothing but its time.
   *
   * After a checkpoint of every n steps the object is thrown away and made
   * anew from the file, in the run that wrote it just as in a restarted one:
   * both go on with the same numbers because they are the same program path.
   */
  template <int dim>
  class Simulation
  {
  public:
    /// Build the grid and fill it, with the bodies of the scene or the points
    /// of a checkpoint (null: none). Throws InputError; writes no file.
    /// References must outlive the run. Collective.
    Simulation(PlannedScene<dim>                &planned,
               const std::string                &directory,
               RunReport                        &report,
               TimerTree                        &timer,
               std::unique_ptr<const Checkpoint> start);

    /// Sizes of the run, for the user. Collective.
    std::string
    description() const;

    /// From the start to the end time, then the summary; or to a checkpoint
    /// after which this object is not to go on. The first good step makes the
    /// last but one results of the folder superfluous. Collective.
    RunOutcome
    run(CheckpointSchedule   &schedule,
        CheckpointFolder     &folder,
        const EarlierResults &earlier);

    // run() in parts, for programs of their own (stepped_run.h)

    /// Everything before the first step. Collective.
    void
    begin();

    /// A step and a row of statistics. False if @p stop_is_wanted (all ranks
    /// alike) while the step was being repeated: the points are as they were
    /// at its start. Collective.
    bool
    advance(const std::function<bool()> &stop_is_wanted);

    /// After the last step: the summary. Collective.
    void
    finish();

    double
    time() const
    {
      return time_stepper.time(); // [s]
    }
    bool
    finished() const
    {
      return is_empty || time_stepper.finished();
    }
    const StatisticsTable &
    statistics_table() const
    {
      return statistics;
    }
    /// Grid, points and all that works on them.
    const Problem<dim> &
    objects() const
    {
      return problem;
    }

  private:
    // what advance() consists of; collective

    /// NumericalError, with a frame and advice, if one is lost.
    void
    locate_points();

    /// What solids have done in the step. Collective.
    void
    add_work_of_solids();

    /// Shifting and reseeding, once a step.
    void
    control_points();

    void
    points_to_grid();

    /// Time and size of the step.
    void
    begin_step();

    /// True if the start velocity is to satisfy the constraint.
    bool
    start_is_projected() const;

    /// Is @p attempt() at the step done? It is repeated with a smaller size
    /// while it throws StepFailure or its error is too large. NumericalError
    /// if there is no smaller size; false as in advance().
    bool
    repeat_until_accepted(const std::function<void()> &attempt,
                          const std::function<bool()> &stop_is_wanted);

    /// StepFailure if points cannot move as the grid has.
    void
    check_step();

    /// Of a point in the step [cells]: walls that move take a part of it.
    double
    largest_way() const;

    void
    grid_to_points();

    /// Points that have come too close to one another move apart.
    void
    project_density();

    /// Velocity (and acceleration, pressure) that fit the constraint.
    void
    prepare_start();

    /// Points and grid after a step of @p dt [s], 0: before the first.
    StepView<dim>
    step_view(const double dt) const;

    void
    postprocess();

    /// What the energy has gained over that at the start, if nothing feeds it
    /// and it is too much for a stable run; else zero.
    double
    suspicious_energy_gain() const;

    /// Of the last attempt.
    void
    count_iterations();

    /// The points and cells of a step that cannot be done, as they are at its
    /// start, into the folder "failure" of the output. Collective.
    void
    write_failure();

    /// The points alone, as they are: where one of them is lost. Collective.
    void
    write_failed_points();

    /// All that is carried from step to step but the points (and, within the
    /// solver's tolerance, which tangents Newton makes anew). Collective.
    void
    save_or_load(StateArchive &archive);
    void
    write_checkpoint(CheckpointFolder &folder);

    Scene<dim>       &scene;
    const std::string directory;
    const MPI_Comm    communicator;
    RunReport        &report;
    TimerTree        &timer;
    /// Until the run begins: it holds a file open, and memory.
    std::unique_ptr<const Checkpoint> start;

    Problem<dim>        problem;
    GridState<dim>      state;
    StepSolver<dim>     step_solver;
    TimeStepper         time_stepper;
    ChamberNotices<dim> chamber_notices;
    const double        expected_step; ///< of SceneScales [s]
    AcceptedFailures    accepted_failures;
    StatisticsTable     statistics;

    StepBalance<dim>    balance;        ///< of the last step, if the tank moves
    std::vector<double> work_of_solids; ///< [J] on the fluid, if one moves

    bool is_on_grid            = false; ///< what the points carry now
    bool points_are_controlled = false; ///< PointControl has seen to them
    bool is_empty              = false; ///< all fluid has left

    /// What the last step has come to.
    struct StepRecord
    {
      unsigned int newton = 0, krylov = 0; ///< iterations of all attempts
      double       speed = 0.; ///< of points and walls over cells [1/s]
      double       error = 0.; ///< StepSolver::local_error() [cells]
    };
    StepRecord record;

    std::uint64_t newton_total = 0, krylov_total = 0;
    std::uint64_t occupied_max = 0, unknowns_max = 0;
  };
} // namespace seiche

#endif
