// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_input_problems_h
#define seiche_parameters_input_problems_h

#include <functional>
#include <string>
#include <vector>

namespace seiche
{
  /// Throw InputError with one problem a line (no more than 20) if there is
  /// any.
  void
  throw_problems(const std::vector<std::string> &problems);

  /// InputError with the mistakes that all checks found, which do not need each
  /// other.
  void
  require_all(const std::vector<std::function<void()>> &checks);
} // namespace seiche

#endif
