// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_regular_file_h
#define seiche_utilities_regular_file_h

#include <cstdint>
#include <string>

namespace seiche
{
  /// Why a file that shall be read is none that can be: missing, a folder, a
  /// pipe or a device (which may wait or never end), larger than @p largest
  /// [bytes]; empty if nothing is wrong. Local.
  std::string
  problem_of_file(const std::string &filename, const std::uintmax_t largest);
} // namespace seiche

#endif
