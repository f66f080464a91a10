// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_input_text_h
#define seiche_parameters_input_text_h

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

    /// Set the entry of the last of the names in the subsections of the others.
    /// InputError for names that no file could have.
    void
    set(const std::vector<std::string> &names,
        const std::string              &value,
        const std::string              &origin);

    /// FILE:LINE of an entry; of its subsection, or of the end of the file,
    /// if it is not set.
    std::string
    origin(const std::string &path) const;
  };

  /// The entries of a program. InputError for names that no file could have.
  /// Local.
  InputText
  read_entries(const SceneEntries &entries);

  /// Apply overrides "Subsection/Entry = value". InputError for a text of
  /// another form and for an entry given twice. Local.
  void
  apply_overrides(const std::vector<std::string> &overrides, InputText &text);

  /// `SUBSECTION/ENTRY` of its names.
  std::string
  path_of_names(const std::vector<std::string> &names);

  /// What is wrong with the name of a subsection, to follow its place; empty if
  /// nothing is.
  std::string
  problem_of_name(const std::string &name);
} // namespace seiche

#endif
