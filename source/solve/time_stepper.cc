// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/solve/time_stepper.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// After this many good steps a reduced size grows by this factor.
    constexpr unsigned int steps_before_growth = 3;
    constexpr double       growth              = 1.5;

    /// Halvings of the step before giving up, if no smallest step is given.
    constexpr double default_smallest_share = 1. / 1024.;

    /// The first step, of which no error is known, over Step.
    constexpr double first_share = 0.1;

    /// Of the step that would just meet the tolerance, and how much the size
    /// may change from step to step.
    constexpr double safety = 0.9, largest_growth = 1.5, largest_cut = 0.3;

    /// Of the size that Step and CFL number allow, what the error may cut it
    /// to: noise of the pressure grows in still smaller steps, and so would the
    /// estimate (doc/methods.md, size of the step).
    constexpr double least_share = 0.02;

    /// A step with more than this multiple of its share of the error is
    /// repeated.
    constexpr double repeat_above = 2.;

    /// A last step may be this much longer: what rounding of Step leaves.
    constexpr double stretch = 1. + 1e-6;
  } // namespace

  void
  TimeStepParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("End time",
                      end_time,
                      "End of the simulated time [s]",
                      Patterns::Double(0.),
                      /*has_to_be_set=*/true);
    add_step_size_parameters(prm);
    prm.add_parameter(
      "Failing steps",
      failing_steps,
      "What becomes of a step whose Newton iteration does not "
      "converge, or that crushes a point or moves it farther "
      "than Maximum displacement. repeated: with half its "
      "size. accepted: as in the code of the founding paper it "
      "is taken, with the iterate of the least residual; a "
      "point goes only the part of its way on which it keeps "
      "a fifth of its volume, moves no farther than Maximum "
      "displacement and passes no wall (unilateral ones set it back), and its volume ratio is "
      "kept within 0.25 of one then; summary.json counts such "
      "steps and points. A "
      "residual that is not finite repeats the step even so",
      Patterns::Selection("repeated|accepted"));
    prm.add_parameter("Velocity projection",
                      projection,
                      "When the start velocity is made to satisfy the "
                      "discrete constraint (mixed form); one linear solve",
                      Patterns::Selection("each step|at the start"));
    prm.leave_subsection();
  }

  void
  TimeStepParameters::add_step_size_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Step",
                      step,
                      "Step size, the largest one if it is controlled; with "
                      "Step control = error the first is a tenth of it [s]",
                      Patterns::Double(1e-300),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Step control",
                      control,
                      "fixed; CFL: from the largest speed; error: so that the "
                      "errors of all steps add up to Error tolerance; at most "
                      "what Step and CFL number allow, at least 1/50 of that "
                      "and Minimum step",
                      Patterns::Selection("fixed|CFL|error"));
    prm.add_parameter("CFL number",
                      cfl,
                      "Cells that the fastest point crosses in a step with "
                      "Step control = CFL, at most with error [-]",
                      Patterns::Double(1e-6, 1.));
    prm.add_parameter("Error tolerance",
                      error_tolerance,
                      "What the steps may add to the points' ways in a second "
                      "with Step control = error, root mean square over the "
                      "mass [cells/s]",
                      Patterns::Double(1e-12));
    prm.add_parameter("Minimum step",
                      minimum_step,
                      "A step that fails at half this size ends the run; 0: "
                      "1/1024 of Step [s]",
                      Patterns::Double(0.));
    prm.add_parameter("Maximum displacement",
                      maximum_displacement,
                      "A step that moves a point farther is repeated with "
                      "half its size [cells]",
                      Patterns::Double(1e-3, 1.));
  }

  void
  TimeStepParameters::check(const InputFile &input) const
  {
    input.read_only_if(is_controlled(),
                       "Time/CFL number",
                       "Time/Step control = CFL or error");
    input.read_only_if(controls_error(),
                       "Time/Error tolerance",
                       "Time/Step control = error");
    input.require(minimum_step <= step,
                  "Time/Minimum step",
                  "it must not exceed Time/Step");
    constexpr double most_steps = std::numeric_limits<unsigned int>::max();
    input.require(end_time / step < most_steps,
                  "Time/End time",
                  "that are more than 2^32 steps: choose an earlier end or "
                  "a larger Time/Step");
    input.require(!(accepts_failing_steps() && controls_error()),
                  "Time/Failing steps",
                  "the error of a step that has not converged says nothing "
                  "about the step size: set it to repeated, or Step control "
                  "to fixed or CFL");
  }

  TimeStepper::TimeStepper(const TimeStepParameters &p, const std::string &a)
    : parameters(p)
    , advice(a)
  {}

  bool
  TimeStepper::finished() const
  {
    return now >= parameters.end_time * (1. - 1e-12);
  }

  double
  TimeStepper::smallest_step() const
  {
    return parameters.minimum_step > 0. ?
             parameters.minimum_step :
             default_smallest_share * parameters.step;
  }

  double
  TimeStepper::next_step(const double speed_per_cell)
  {
    limit = parameters.step;
    if (parameters.is_controlled() && speed_per_cell * limit > parameters.cfl)
      limit = parameters.cfl / speed_per_cell;
    dt = std::max(reduction * limit, smallest_step());
    if (parameters.controls_error())
      {
        if (reduction < 1.) // of a step that was smaller than the limit
          dt = std::min(dt, std::max(largest_after_failure, smallest_step()));
        least_accurate =
          std::min(std::max(least_share * limit, smallest_step()), dt);
        dt = std::clamp(wanted_dt > 0. ? wanted_dt : first_share * limit,
                        least_accurate,
                        dt);
      }
    const double rest = parameters.end_time - now;
    if (rest <= stretch * dt)
      dt = rest;
    else if (rest < 2. * dt)
      dt = 0.5 * rest; // no tiny last step
    first_tried = dt;
    return dt;
  }

  double
  TimeStepper::repeat(const std::string &reason)
  {
    ++n_rejected;
    good_steps = 0;
    reduction =
      std::max(0.5 * reduction, std::min(1., smallest_step() / limit));
    dt *= 0.5;
    largest_after_failure = dt;
    if (dt < 0.5 * std::min(smallest_step(), first_tried)) // a short last one
      throw NumericalError(fmt::format(
        "step {}, t = {:.6g} s: {}, also at the smallest step {:.3g} s. "
        "The points are as they were at the start of this step. {}",
        n_steps + 1,
        now,
        reason,
        2. * dt,
        advice));
    return dt;
  }

  double
  TimeStepper::allowed_error() const
  {
    return parameters.error_tolerance * dt;
  }

  double
  TimeStepper::size_for_error(const double error) const
  {
    // the local error grows with dt^3, its share of the tolerance with dt; an
    // error that is no number cuts the step
    const double factor =
      std::min(largest_growth,
               std::max(largest_cut,
                        safety * std::sqrt(allowed_error() / error)));
    return std::max(factor * dt, least_accurate);
  }

  ErrorVerdict
  TimeStepper::judge(const double error) const
  {
    if (!parameters.controls_error() || error <= repeat_above * allowed_error())
      return ErrorVerdict::accepted;
    return dt <= least_accurate ? ErrorVerdict::accepted_at_least_size :
                                  ErrorVerdict::too_large;
  }

  double
  TimeStepper::repeat_for_error(const double error)
  {
    ++n_rejected;
    wanted_dt = size_for_error(error);
    return dt = wanted_dt;
  }

  void
  TimeStepper::accept(const double error)
  {
    if (parameters.controls_error())
      {
        wanted_dt = size_for_error(error);
        error_sum += error;
      }
    now += dt;
    previous_dt = dt;
    ++n_steps;
    if (reduction < 1. && ++good_steps >= steps_before_growth)
      {
        good_steps = 0;
        reduction  = std::min(1., growth * reduction);
        largest_after_failure *= growth;
      }
  }

  void
  TimeStepper::save_or_load(StateArchive &archive)
  {
    archive("time", now);
    archive("previous step", previous_dt);
    archive("wanted step", wanted_dt);
    archive("error", error_sum);
    archive("reduction", reduction);
    archive("largest step after a failure", largest_after_failure);
    archive("good steps", good_steps);
    archive("steps", n_steps);
    archive("rejected steps", n_rejected);
  }
} // namespace seiche
