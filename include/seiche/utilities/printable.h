// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_printable_h
#define seiche_utilities_printable_h

#include <string>

namespace seiche
{
  /// The text for a terminal: control characters (but ends of lines) as "?",
  /// of a line what fits into @p longest bytes.
  inline std::string
  printable(const std::string &text, const std::size_t longest)
  {
    std::string result;
    std::size_t length = 0;
    for (const char c : text)
      {
        length = c == '\n' ? 0 : length + 1;
        if (length == longest + 1)
          result += " ...";
        if (length > longest)
          continue;
        const auto code       = static_cast<unsigned char>(c);
        const bool is_control = (code < 32 && c != '\n') || code == 127;
        result += is_control ? '?' : c;
      }
    return result;
  }
} // namespace seiche

#endif
