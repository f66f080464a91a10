// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_time_stepper_h
#define seiche_solve_time_stepper_h

#include <algorithm>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;
  class StateArchive;

  /// prm entries of the step size (subsection "Time").
  struct TimeStepParameters
  {
    double      end_time             = 0.;
    double      step                 = 1.;
    std::string control              = "fixed";
    double      cfl                  = 0.4;
    double      error_tolerance      = 0.01;
    double      minimum_step         = 0.;
    double      maximum_displacement = 1.;
    std::string failing_steps        = "repeated";
    std::string projection           = "each step";

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input) const;

    /// True if steps that have not converged are taken all the same.
    bool
    accepts_failing_steps() const
    {
      return failing_steps == "accepted";
    }
    bool
    projects_each_step() const
    {
      return projection == "each step";
    }
    bool
    is_controlled() const
    {
      return control != "fixed";
    }
    bool
    controls_courant_number() const
    {
      return control == "CFL";
    }
    bool
    controls_error() const
    {
      return control == "error";
    }

  private:
    void
    add_step_size_parameters(dealii::ParameterHandler &prm);
  };

  /// What the local error of a step says of its size.
  enum class ErrorVerdict
  {
    accepted,
    accepted_at_least_size, ///< too large, but no size below would help
    too_large
  };

  /**
   * @brief Size of the next step: fixed, from the CFL number or from the error
   * of the steps before (doc/theory.md (3.5)), halved after a failure, restored
   * by and by.
   */
  class TimeStepper
  {
  public:
    /// @p advice: what may help where a step fails at every size, a sentence.
    TimeStepper(const TimeStepParameters &parameters,
                const std::string        &advice);

    /// The advice, a sentence.
    const std::string &
    what_may_help() const
    {
      return advice;
    }

    /// Size [s] of the step that starts now. @p speed_per_cell: largest speed
    /// over the cell's edge [1/s], all ranks.
    double
    next_step(const double speed_per_cell);

    /// The step failed: the size of its repetition, or NumericalError with
    /// the reason and advice at the smallest size.
    double
    repeat(const std::string &reason);

    /// Of a step with this local error [cells]; accepted unless the error is
    /// controlled.
    ErrorVerdict
    judge(const double error) const;

    /// The local error [cells] is too large: the size of the repetition [s].
    double
    repeat_for_error(const double error);

    /// True if the step that starts has been tried with a larger size.
    bool
    is_repeated() const
    {
      return dt < first_tried;
    }

    /// The step of next_step() or its last repetition is done, with this local
    /// error [cells] if it is controlled.
    void
    accept(const double error);

    /// Where the run is, for a checkpoint. Local.
    void
    save_or_load(StateArchive &archive);

    double
    time() const
    {
      return now;
    }
    /// Size of the step before [s], 0 if there is none.
    double
    previous_step() const
    {
      return previous_dt;
    }
    /// Sum of the local errors of all steps [cells].
    double
    error() const
    {
      return error_sum;
    }
    bool
    finished() const;
    unsigned int
    steps() const
    {
      return n_steps;
    }
    unsigned int
    rejected() const
    {
      return n_rejected;
    }

  private:
    double
    smallest_step() const;

    /// [cells] that a step of this size may add to the error.
    double
    allowed_error() const;

    /// [s] at which the next step would meet the tolerance, by the error
    /// [cells] of this one.
    double
    size_for_error(const double error) const;

    const TimeStepParameters parameters;
    const std::string        advice;
    double                   now         = 0.; ///< [s] start of the step
    double                   dt          = 0.; ///< [s] of the step
    double                   first_tried = 0.; ///< [s] before it was repeated
    double                   previous_dt = 0.; ///< [s] of the step before
    double                   wanted_dt = 0.; ///< [s] by the error; 0: none yet
    double least_accurate = 0.; ///< [s] the error cuts a step to this at most
    double error_sum      = 0.; ///< [cells] of the steps before
    double reduction      = 1.; ///< of limit, after failures
    double limit          = 0.; ///< [s] by Step and CFL number
    /// [s] of steps that the error controls, while reduction < 1
    double       largest_after_failure = 0.;
    unsigned int good_steps            = 0; ///< since the last failure
    unsigned int n_steps               = 0;
    unsigned int n_rejected            = 0;
  };
} // namespace seiche

#endif
