// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_declarations_h
#define seiche_parameters_declarations_h

#include <map>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /**
   * @brief One entry of a parameter file as it was declared.
   */
  struct Declaration
  {
    std::string path;          ///< "Fluid/Density"
    std::string default_value; ///< without meaning if mandatory
    std::string text;          ///< what it is, with its unit in brackets
    std::string pattern;       ///< deal.II's description of the pattern
    bool        mandatory = false;

    /// What is allowed, in words: `a number >= 0`.
    std::string
    allowed() const;

    /// The names of a Selection pattern, else empty.
    std::vector<std::string>
    choices() const;

    /// True if the value is the name of a file.
    bool
    is_file() const;

    /// True if the pattern accepts the value.
    bool
    accepts(const std::string &value) const;

    /// The unit at the end of the text, "[Pa]", or empty.
    std::string
    unit() const;

    /// `Allowed: a number >= 0 [Pa].` for messages.
    std::string
    allowed_text() const;

    /// ` Meaning: Density of the fluid.`, without the unit at the end.
    std::string
    meaning_text() const;
  };

  /// All entries of @p prm, in the order of their declaration. No entry may
  /// have been set yet (that is how mandatory ones are known).
  std::vector<Declaration>
  declarations(const dealii::ParameterHandler &prm);

  /// The value that every entry of @p prm has now, by its path.
  std::map<std::string, std::string>
  current_values(const dealii::ParameterHandler &prm);

  /// Part of a path after its last "/": the name of the entry.
  std::string
  entry_name(const std::string &path);

  /// Part of a path before its last "/": the subsection, empty at the top.
  std::string
  subsection_name(const std::string &path);

  /// `entry "E" in "S"`.
  std::string
  entry_in_words(const std::string &path);
} // namespace seiche

#endif
