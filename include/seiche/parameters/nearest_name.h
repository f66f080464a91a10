// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_nearest_name_h
#define seiche_parameters_nearest_name_h

#include <string>
#include <vector>

namespace seiche
{
  /// Number of letters to insert, delete, replace or swap with the next one
  /// until @p a reads @p b; case does not count.
  unsigned int
  edit_distance(const std::string &a, const std::string &b);

  /// The known name that @p name was probably meant to be; empty if none is
  /// near enough (a third of the letters wrong, at least two).
  std::string
  nearest_name(const std::string &name, const std::vector<std::string> &known);

  /// `; did you mean "X"?` or an empty text.
  std::string
  nearest_hint(const std::string &name, const std::vector<std::string> &known);

  /// `"a", "b", "c"`.
  std::string
  quoted_list(const std::vector<std::string> &names);
} // namespace seiche

#endif
