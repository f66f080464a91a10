// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_input_lines_h
#define seiche_parameters_input_lines_h

#include <string>
#include <vector>

namespace seiche
{
  struct InputLine
  {
    std::string  text;   ///< without comment and blanks around
    unsigned int number; ///< from 1, of the first if several are continued
  };

  /// The lines of a parameter file that are not empty.
  struct InputLines
  {
    std::string            problem; ///< if it cannot be one of ours, or empty
    std::vector<InputLine> lines;
    unsigned int           n_lines = 0; ///< of the file
  };

  /// Read a file: comments from # on, lines continued by a backslash. Local.
  InputLines
  read_lines(const std::string &filename);
} // namespace seiche

#endif
