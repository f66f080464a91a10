// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/solve/time_stepper.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <algorithm>

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

    /// A last step may be this much longer, so that none is tiny.
    constexpr double stretch = 1. + 1e-9;
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
    prm.add_parameter("Step",
                      step,
                      "Step size, the largest one if it is controlled [s]",
                      Patterns::Double(1e-300),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Step control",
                      control,
                      "fixed, or CFL: from the largest speed",
                      Patterns::Selection("fixed|CFL"));
    prm.add_parameter("CFL number",
                      cfl,
                      "Cells that the fastest point crosses in a step with "
                      "Step control = CFL [-]",
                      Patterns::Double(1e-6, 1.));
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
    prm.add_parameter("Velocity projection",
                      projection,
                      "When the start velocity is made to satisfy the "
                      "discrete constraint (mixed form); one linear solve",
                      Patterns::Selection("each step|at the start"));
    prm.add_parameter("Projection sweeps",
                      projection_sweeps,
                      "How often a step's start velocity is projected, with "
                      "the same matrix: 2 or 3 take the noise out of the "
                      "pressure of small steps, which grows as dt^-1/2 [-]",
                      Patterns::Integer(1, 100));
    prm.leave_subsection();
  }

  void
  TimeStepParameters::check(const InputFile &input) const
  {
    input.require(minimum_step <= step,
                  "Time/Minimum step",
                  "it must not exceed Time/Step");
  }

  TimeStepper::TimeStepper(const TimeStepParameters &p)
    : parameters(p)
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
    dt = parameters.step;
    if (parameters.control == "CFL")
      {
        if (speed_per_cell * dt > parameters.cfl)
          dt = parameters.cfl / speed_per_cell;
        dt = std::max(dt, smallest_step());
      }
    dt                = std::max(dt * reduction, smallest_step());
    const double rest = parameters.end_time - now;
    if (rest <= stretch * dt)
      dt = rest;
    else if (parameters.control == "CFL" && rest < 2. * dt)
      dt = 0.5 * rest; // no tiny last step
    return dt;
  }

  double
  TimeStepper::repeat(const std::string &reason)
  {
    ++n_rejected;
    good_steps = 0;
    reduction *= 0.5;
    dt *= 0.5;
    if (dt < 0.5 * smallest_step())
      throw NumericalError(fmt::format(
        "step {}, t = {:.6g} s: {}, also at the smallest step {:.3g} s. "
        "The points are as they were at the start of this step. What may "
        "help: a smaller Time/Step or Step control = CFL, a larger Free "
        "surface/Ghost velocity, a smaller Free surface/Ghost velocity time, a "
        "larger Formulation/Tau continuity factor, more points per cell, "
        "or a smaller Time/Minimum step.",
        n_steps + 1,
        now,
        reason,
        2. * dt));
    return dt;
  }

  void
  TimeStepper::accept()
  {
    now += dt;
    ++n_steps;
    if (reduction < 1. && ++good_steps >= steps_before_growth)
      {
        good_steps = 0;
        reduction  = std::min(1., growth * reduction);
      }
  }

  void
  TimeStepper::save_or_load(StateArchive &archive)
  {
    archive("time", now);
    archive("reduction", reduction);
    archive("good steps", good_steps);
    archive("steps", n_steps);
    archive("rejected steps", n_rejected);
  }
} // namespace seiche
