// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_readable_h
#define seiche_utilities_readable_h

#include <string>

namespace seiche
{
  /// "3.2 years", "12 days", "2.1 h", "3.5 min" or "25 s". Local.
  std::string
  readable_duration(const double seconds);

  /// "850 B", "1.2 MB" or "3.5 GB", of 1000 each. Local.
  std::string
  readable_size(const double bytes);

  /// "640", "12300" or "1.2e+08". Local.
  std::string
  readable_count(const double number);
} // namespace seiche

#endif
