// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_axis_names_h
#define seiche_utilities_axis_names_h

#include <array>

namespace seiche
{
  /// Names of the directions in columns of tables.
  constexpr std::array<const char *, 3> axis_names = {{"x", "y", "z"}};
} // namespace seiche

#endif
