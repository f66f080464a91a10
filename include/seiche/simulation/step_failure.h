// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_step_failure_h
#define seiche_simulation_step_failure_h

#include <stdexcept>

namespace seiche
{
  /// A step cannot be done with its size, but perhaps with a smaller one:
  /// thrown on all ranks alike, and answered by repeating the step.
  class StepFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace seiche

#endif
