// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_failure_text_h
#define seiche_utilities_failure_text_h

#include <exception>
#include <string>

namespace seiche
{
  /// Whether an exception says that the system gave no more memory: the
  /// language's or deal.II's.
  bool
  is_exhausted_memory(const std::exception &error);

  /// For the user, of an exception that may come from a library: advice if
  /// memory is exhausted, otherwise what the exception says.
  std::string
  failure_text(const std::exception &error);
} // namespace seiche

#endif
