// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_folder_name_h
#define seiche_utilities_folder_name_h

#include <string>

namespace seiche
{
  /// Path of a folder that a user may have named by a link or as "." or "x/":
  /// what is appended to it names a place beside the folder. It need not exist.
  std::string
  folder_name(const std::string &directory);
} // namespace seiche

#endif
