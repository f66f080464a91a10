// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_input_reader_h
#define seiche_parameters_input_reader_h

#include <seiche/parameters/input_text.h>

#include <string>

namespace seiche
{
  /**
   * Read a file in the syntax of deal.II's ParameterHandler: `subsection`,
   * `end`, `set NAME = VALUE`, `include FILE` (relative to the file that
   * includes it), comments from # on, lines continued by a backslash. An
   * entry may be set once; only a file may change, further down, what it has
   * included. InputError lists all problems, each with file and line. Local.
   */
  InputText
  read_input(const std::string &filename);
} // namespace seiche

#endif
