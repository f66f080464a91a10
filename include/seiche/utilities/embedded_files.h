// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_embedded_files_h
#define seiche_utilities_embedded_files_h

#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief A file of the project that is part of the program, so that it works
   * wherever it is installed (CMakeLists.txt says which ones).
   */
  struct EmbeddedFile
  {
    const char *folder; ///< "examples", "self_test" or "references"
    const char *name;   ///< without ending: "dam_break"
    const char *text;
  };

  /// All files of a folder, by name.
  std::vector<EmbeddedFile>
  embedded_files(const std::string &folder);
} // namespace seiche

#endif
