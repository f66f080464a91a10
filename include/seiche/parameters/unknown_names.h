// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_unknown_names_h
#define seiche_parameters_unknown_names_h

#include <seiche/parameters/declarations.h>
#include <seiche/parameters/input_text.h>

#include <set>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief The entries and subsections of a file that are not declared, each
   * with the nearest name or what there is. References must outlive the object.
   */
  class UnknownNames
  {
  public:
    /// @p kinds: of subsections "<kind> NAME" that may occur any number of
    /// times.
    UnknownNames(const InputText                &input_text,
                 const std::set<std::string>    &kinds_of_instances,
                 const std::vector<Declaration> &declared)
      : text(input_text)
      , kinds(kinds_of_instances)
      , known(declared)
    {}

    /// A text for each, in the order of the file.
    std::vector<std::string>
    problems() const;

  private:
    /// True for "<kind> NAME".
    bool
    is_instance(const std::string &subsection) const;
    std::string
    unknown_subsection(const std::string           &path,
                       const std::set<std::string> &subsections) const;
    std::string
    unknown_entry(const std::string &path) const;

    const InputText                &text;
    const std::set<std::string>    &kinds;
    const std::vector<Declaration> &known;
  };
} // namespace seiche

#endif
