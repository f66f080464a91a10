// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_self_test_h
#define seiche_simulation_self_test_h

#include <seiche/utilities/exceptions.h>

#include <string>
#include <vector>

namespace seiche
{
  /**
   * Compute the scenes of prm/self_test, which are part of the program, in a
   * temporary folder and print a line for each: whether its scores are within
   * the bounds of its verdicts. @p overrides: of all scenes, as those of --set.
   * ExitCode::finished or, if a scene fails, ExitCode::numerical. Collective.
   */
  ExitCode
  self_test(const std::vector<std::string> &overrides);
} // namespace seiche

#endif
