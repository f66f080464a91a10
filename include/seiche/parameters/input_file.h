// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_input_file_h
#define seiche_parameters_input_file_h

#include <seiche/parameters/input_text.h>

#include <set>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /**
   * @brief A parameter file with the place of every entry.
   *
   * deal.II's ParameterHandler keeps the declarations (names, defaults,
   * patterns, texts). This class reads the file itself, so that every error,
   * also one found long after parsing, can name file, line, entry and value,
   * the nearest known name, what is allowed and what to type; and so that it
   * refuses what ParameterHandler 9.4.1 lets pass: a file that includes
   * itself, an entry set twice, a directory, an empty file.
   *
   * Entries are addressed by paths such as "Fluid body column/Shape".
   */
  class InputFile
  {
  public:
    /// Read the file with its includes, then the overrides of the form
    /// "Subsection/Entry = value". Throws InputError. Local (every rank reads).
    InputFile(const std::string              &filename,
              const std::vector<std::string> &overrides);

    /// The scene of a program instead of a file's; tables lie in the current
    /// directory. Throws InputError. Local.
    explicit InputFile(const SceneEntries &entries);

    /// A stand-in without entries to collect declarations from: every kind
    /// of instance occurs once, with the name NAME.
    static InputFile
    for_documentation();

    /// The entry "Dimension": 2 or 3; InputError for anything else.
    unsigned int
    dimension() const;

    /// Declare the entry "Dimension", which belongs to no struct.
    static void
    declare_dimension(dealii::ParameterHandler &prm);

    /// Names of the subsections "<kind> NAME" of a kind that may occur any
    /// number of times ("Fluid body", "Probe"), in the order of the file.
    std::vector<std::string>
    instances(const std::string &kind) const;

    /// Value of an entry, or @p fallback if it is not set.
    std::string
    value(const std::string &path, const std::string &fallback = "") const;

    /// True if the entry has a value that is not empty and, once parse_into()
    /// knows it, not the default: a file with all entries written out
    /// (parameters.prm) means the same as the short one.
    bool
    is_set(const std::string &path) const;

    /// True if some value calls a function: NAME(...).
    bool
    calls(const std::string &name) const;

    /// Hand all entries to the declarations. Throws InputError for an unknown
    /// entry or subsection (with the nearest name), a value that its pattern
    /// refuses (with what is allowed), a mandatory entry that is not set.
    void
    parse_into(dealii::ParameterHandler &prm) const;

    /// Throw InputError `FILE:LINE: entry "E" in "S" = V: problem`. The
    /// problem text says what is allowed and what to change.
    [[noreturn]] void
    fail(const std::string &path, const std::string &problem) const;

    /// fail() unless @p condition holds.
    void
    require(const bool         condition,
            const std::string &path,
            const std::string &problem) const
    {
      if (!condition)
        fail(path, problem);
    }

    /// State that the scene reads an entry only with @p reader ("Time/Step
    /// control = CFL"), and whether it has that: checks of options call it. An
    /// included file may have entries that only some of its users read.
    void
    read_only_if(const bool         has_reader,
                 const std::string &path,
                 const std::string &reader) const;

    /// One text for each entry that is set although the scene does not read it.
    const std::vector<std::string> &
    without_effect() const
    {
      return set_in_vain;
    }

    /// State that the scene uses what these papers describe: keys of
    /// doc/references.bib, blanks between them. Checks of options call it with
    /// what the row of their table says.
    void
    cites(const std::string &keys) const;

    /// The keys so far, each once.
    const std::vector<std::string> &
    cited() const
    {
      return papers;
    }

    const std::string filename;

    /// A file that an entry names: absolute, or relative to the parameter file.
    std::string
    file_beside(const std::string &name) const;

  private:
    InputFile() = default;

    InputText text;
    bool      documentation = false;
    // asked for so far: the hints for misspelt kinds need them
    mutable std::set<std::string>    kinds;
    mutable std::set<std::string>    entries_at_default;
    mutable std::vector<std::string> set_in_vain;
    mutable std::vector<std::string> papers;
  };
} // namespace seiche

#endif
