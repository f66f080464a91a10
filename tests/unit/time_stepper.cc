// SPDX-License-Identifier: LGPL-2.1-or-later
// TimeStepper: sizes of steps after failures and large errors, of the last
// step, and when it gives up.
#include <seiche/solve/time_stepper.h>
#include <seiche/utilities/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "verdict.h"

namespace
{
  using seiche::ErrorVerdict;
  using seiche::TimeStepParameters;
  using seiche::TimeStepper;

  constexpr double large_error = 1.; // [cells]

  TimeStepParameters
  make_parameters(const std::string &control)
  {
    TimeStepParameters result;
    result.control         = control;
    result.step            = 1.;
    result.end_time        = 100.;
    result.cfl             = 0.5;
    result.error_tolerance = 0.01;
    return result;
  }

  /// Two failures, then steps that succeed: a quarter of the size, which grows
  /// by half after each three steps until it is past the one that failed.
  void
  test_failures(const std::string &control)
  {
    TimeStepper  stepper(make_parameters(control), "");
    const bool   by_error = control == "error";
    double       expected = by_error ? 0.1 : 1., failed = 0.;
    unsigned int n_left = 0;
    bool         right  = true;
    for (unsigned int step = 0; step < 16; ++step)
      {
        double dt = stepper.next_step(/*speed_per_cell=*/0.1);
        if (step == 2)
          {
            for (unsigned int i = 0; i < 2; ++i)
              dt = stepper.repeat("as a test");
            failed = expected;
            expected /= 4.;
            n_left = 3;
          }
        stepper.accept(/*error=*/1e-6);
        right &= std::abs(dt / expected - 1.) < 1e-12;
        if (expected >= failed || --n_left == 0)
          {
            expected = by_error ? 1.5 * expected : std::min(1.5 * expected, 1.);
            n_left   = 3;
          }
      }
    std::cout << control
              << ": two failures quarter the step, which then grows by half "
                 "after each three steps: "
              << verdict(right) << ", at the end "
              << stepper.previous_step() / failed << " of what failed\n";
  }

  /// An error that no size cures: cuts, then the least size stays.
  void
  test_noise(const double minimum_step, const double speed_per_cell)
  {
    TimeStepParameters parameters = make_parameters("error");
    parameters.minimum_step       = minimum_step;
    TimeStepper stepper(parameters, "Try this.");
    for (unsigned int step = 0; step < 20; ++step)
      {
        stepper.next_step(speed_per_cell);
        while (stepper.judge(large_error) == ErrorVerdict::too_large)
          stepper.repeat_for_error(large_error);
        stepper.accept(large_error);
      }
    std::cout << "noise, smallest step " << minimum_step << ", speed "
              << speed_per_cell << ": size " << stepper.previous_step()
              << ", repeated " << stepper.rejected() << '\n';
  }

  /// At the least size that the error allows a step fails at all sizes above
  /// half of it: it must not try them in every step.
  void
  test_failures_at_least_size()
  {
    TimeStepper  stepper(make_parameters("error"), "");
    unsigned int failures = 0;
    for (unsigned int step = 0; step < 20; ++step)
      {
        double dt = stepper.next_step(/*speed_per_cell=*/0.1);
        while (true)
          {
            for (; step > 8 && dt > 0.011; ++failures)
              dt = stepper.repeat("as a test");
            if (stepper.judge(large_error) != ErrorVerdict::too_large)
              break;
            dt = stepper.repeat_for_error(large_error);
          }
        stepper.accept(large_error);
      }
    std::cout << "failures at the least size: " << failures << ", last step "
              << stepper.previous_step() << '\n';
  }

  /// Steps to an end that is no multiple of them, or not by rounding.
  void
  test_end(const std::string &control, const double step, const double end_time)
  {
    TimeStepParameters parameters = make_parameters(control);
    parameters.step               = step;
    parameters.end_time           = end_time;
    TimeStepper  stepper(parameters, "Try this.");
    double       smallest = step, largest = 0.;
    unsigned int n = 0;
    for (; !stepper.finished(); ++n)
      {
        const double dt = stepper.next_step(/*speed_per_cell=*/0.1);
        smallest        = std::min(smallest, dt);
        largest         = std::max(largest, dt);
        stepper.accept(/*error=*/0.);
      }
    std::cout << control << ", " << end_time << " in steps of " << step << ": "
              << n << " of " << smallest / step << " to " << largest / step
              << " of it, end missed by "
              << std::abs(stepper.time() / end_time - 1.) << '\n';
  }

  /// Failures until it gives up, in the first step to @p end_time.
  void
  test_give_up(const std::string &control, const double end_time)
  {
    TimeStepParameters parameters = make_parameters(control);
    parameters.end_time           = end_time;
    TimeStepper  stepper(parameters, "Try this.");
    unsigned int failures = 0;
    const double begin    = stepper.next_step(0.1);
    try
      {
        while (failures < 100)
          {
            ++failures;
            stepper.repeat("as a test");
          }
      }
    catch (const seiche::NumericalError &error)
      {
        if (std::string(error.what()).find("Try this.") == std::string::npos)
          std::cout << "no advice: ";
        std::cout << control << " from " << begin << ": gives up after "
                  << failures << " failures" << '\n';
      }
  }
} // namespace

int
main()
{
  for (const char *control : {"fixed", "CFL", "error"})
    test_failures(control);
  test_noise(0., 0.1);
  test_noise(0., 100.);
  test_noise(0., 1000.);
  test_noise(0.1, 0.1);
  test_failures_at_least_size();
  for (const char *control : {"fixed", "CFL"})
    {
      test_end(control, 0.0003333333333, 0.5); // 1500 leave 5e-11 s
      test_end(control, 0.1, 10.);
      test_end(control, 0.3, 1.);
      test_end(control, 2., 1.);
    }
  for (const char *control : {"fixed", "CFL", "error"})
    for (const double end_time : {100., 1e-5})
      test_give_up(control, end_time);
}
