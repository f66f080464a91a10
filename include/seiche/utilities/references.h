// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_references_h
#define seiche_utilities_references_h

#include <string>
#include <vector>

namespace seiche
{
  /// The entry of doc/references.bib with this key, as it stands there (it ends
  /// with a line of its own "}"). Throws std::out_of_range for another key.
  std::string
  reference(const std::string &key);

  /// Keys of all entries, in the order of the file.
  std::vector<std::string>
  reference_keys();
} // namespace seiche

#endif
