// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_input_reader_h
#define seiche_parameters_input_reader_h

#include <seiche/parameters/scene_entries.h>

#include <map>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief The entries and subsections of a parameter file, each with its
   * place, as they were written.
   */
  struct InputText
  {
    struct Entry
    {
      std::string  value;
      std::string  origin;    ///< "dam.prm:14" or `--set "Fluid/Density = 1"`
      unsigned int depth = 0; ///< of the include that brought it
    };

    std::map<std::string, Entry>       entries;     ///< by path
    std::map<std::string, std::string> subsections; ///< path -> origin
    /// Paths of entries and subsections in the order of the file.
    std::vector<std::string> order;
    std::string              end; ///< origin of the last line

    /// Note a subsection and those around it.
    void
    add_subsection(const std::string &path, const std::string &origin);
  };

  /**
   * Read a file in the syntax of deal.II's ParameterHandler: `subsection`,
   * `end`, `set NAME = VALUE`, `include FILE` (relative to the file that
   * includes it), comments from # on, lines continued by a backslash. An
   * entry may be set once; only a file may change, further down, what it has
   * included. InputError lists all problems, each with file and line. Local.
   */
  InputText
  read_input(const std::string &filename);

  /// The entries of a program. InputError for names that no file could have.
  /// Local.
  InputText
  read_entries(const SceneEntries &entries);

  /// Apply overrides "Subsection/Entry = value". InputError for a text of
  /// another form and for an entry given twice. Local.
  void
  apply_overrides(const std::vector<std::string> &overrides, InputText &text);

  /// Throw InputError with one problem a line (no more than 20) if there is
  /// any.
  void
  throw_problems(const std::vector<std::string> &problems);
} // namespace seiche

#endif
