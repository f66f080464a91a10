// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/input_problems.h>
#include <seiche/parameters/input_reader.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/parameters/unknown_names.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/references.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace seiche
{
  namespace
  {
    const char *const dimension_entry = "Dimension";

    /// False if the value cannot be converted to the type of the member.
    bool
    set_in(dealii::ParameterHandler &prm,
           const std::string        &path,
           const std::string        &value)
    {
      const auto names =
        dealii::Utilities::split_string_list(subsection_name(path), '/');
      for (const std::string &name : names)
        prm.enter_subsection(name);
      bool converted = true;
      try
        {
          prm.set(entry_name(path), value);
        }
      catch (const std::exception &)
        {
          converted = false;
        }
      for (std::size_t i = 0; i < names.size(); ++i)
        prm.leave_subsection();
      return converted;
    }

    /// Set one entry; the problem as text, empty if there is none.
    std::string
    parse_entry(dealii::ParameterHandler &prm,
                const Declaration        &declaration,
                const std::string        &value)
    {
      std::string problem;
      if (declaration.mandatory && value.empty())
        problem = "the entry is mandatory and its value is missing";
      else if (!declaration.accepts(value))
        problem = "this value is not allowed" +
                  nearest_hint(value, declaration.choices());
      else if (!set_in(prm, declaration.path, value))
        problem = "this value cannot be read";
      else
        return "";
      return problem + (problem.back() == '?' ? " " : ". ") +
             declaration.allowed_text() + declaration.meaning_text();
    }
  } // namespace



  InputFile::InputFile(const std::string              &name,
                       const std::vector<std::string> &overrides)
    : filename(name)
    , text(read_input(name))
  {
    apply_overrides(overrides, text);
  }



  InputFile::InputFile(const SceneEntries &entries)
    : filename("program")
    , text(read_entries(entries))
  {}



  InputFile
  InputFile::for_documentation()
  {
    InputFile input;
    input.documentation = true;
    return input;
  }



  unsigned int
  InputFile::dimension() const
  {
    const std::string dimension = value(dimension_entry);
    require(!dimension.empty(),
            dimension_entry,
            "the entry is mandatory; write \"set Dimension = 2\" or 3.");
    require(dimension == "2" || dimension == "3",
            dimension_entry,
            "this value is not allowed. Allowed: 2 or 3 [-].");
    return dimension == "2" ? 2 : 3;
  }



  void
  InputFile::declare_dimension(dealii::ParameterHandler &prm)
  {
    prm.declare_entry(dimension_entry,
                      "2",
                      dealii::Patterns::Integer(2, 3),
                      "Number of space dimensions [-].",
                      /*has_to_be_set=*/true);
  }



  std::vector<std::string>
  InputFile::instances(const std::string &kind) const
  {
    kinds.insert(kind);
    if (documentation)
      return {"NAME"};
    std::vector<std::string> names;
    for (const std::string &path : text.order)
      if (text.subsections.count(path) > 0 &&
          path.find('/') == std::string::npos &&
          path.compare(0, kind.size() + 1, kind + " ") == 0)
        names.push_back(dealii::Utilities::trim(path.substr(kind.size() + 1)));
    return names;
  }



  std::string
  InputFile::value(const std::string &path, const std::string &fallback) const
  {
    const auto entry = text.entries.find(path);
    return entry == text.entries.end() ? fallback : entry->second.value;
  }



  bool
  InputFile::is_set(const std::string &path) const
  {
    return !value(path).empty() && entries_at_default.count(path) == 0;
  }



  bool
  InputFile::calls(const std::string &name) const
  {
    const std::regex call("(^|[^A-Za-z0-9_])" + name + "\\s*\\(");
    return std::any_of(text.entries.begin(),
                       text.entries.end(),
                       [&](const auto &entry) {
                         return std::regex_search(entry.second.value, call);
                       });
  }



  void
  InputFile::read_only_if(const bool         has_reader,
                          const std::string &path,
                          const std::string &reader) const
  {
    if (has_reader || !is_set(path))
      return;
    // variants of a scene may share what only some of them need
    const std::string place = text.origin(path);
    const bool        is_included =
      place.rfind(filename + ":", 0) != 0 && place.rfind("--set", 0) != 0;
    if (is_included)
      return;
    const std::string warning = place + ": " + entry_in_words(path) + " = " +
                                value(path) + " has no effect: only with " +
                                reader + " is it read";
    if (std::find(set_in_vain.begin(), set_in_vain.end(), warning) ==
        set_in_vain.end())
      set_in_vain.push_back(warning);
  }



  void
  InputFile::cites(const std::string &keys) const
  {
    for (const std::string &key :
         dealii::Utilities::split_string_list(keys, ' '))
      if (!key.empty() &&
          std::find(papers.begin(), papers.end(), key) == papers.end())
        {
          (void)reference(key); // must be there
          papers.push_back(key);
        }
  }



  void
  InputFile::fail(const std::string &path, const std::string &problem) const
  {
    const auto  entry = text.entries.find(path);
    std::string what;
    if (entry != text.entries.end())
      what = entry_in_words(path) + " = " + entry->second.value;
    else if (text.subsections.count(path) > 0)
      what = "subsection \"" + path + "\"";
    else
      what = entry_in_words(path) + " (not set)";
    throw InputError(text.origin(path) + ": " + what + ": " + problem);
  }



  void
  InputFile::parse_into(dealii::ParameterHandler &prm) const
  {
    declare_dimension(prm);
    const std::vector<Declaration> known = declarations(prm);

    std::vector<std::string> problems =
      UnknownNames(text, kinds, known).problems();
    // in the order of the file: the user reads messages from top to bottom
    for (const std::string &path : text.order)
      for (const Declaration &declaration : known)
        if (declaration.path == path && text.entries.count(path) > 0)
          {
            const std::string &value = text.entries.at(path).value;
            // parameters.prm, in another folder, is to mean the same
            const std::string problem =
              parse_entry(prm,
                          declaration,
                          declaration.is_file() && !value.empty() ?
                            std::filesystem::absolute(file_beside(value))
                              .lexically_normal()
                              .string() :
                            value);
            if (value == declaration.default_value && !declaration.mandatory)
              entries_at_default.insert(path);
            if (!problem.empty())
              problems.push_back(text.origin(path) + ": " +
                                 entry_in_words(path) + " = " + value + ": " +
                                 problem);
          }
    for (const Declaration &declaration : known)
      if (declaration.mandatory && text.entries.count(declaration.path) == 0)
        {
          const std::string subsection = subsection_name(declaration.path);
          problems.push_back(fmt::format(
            "{}: {} is mandatory and not set; write \"set {} = ...\"{}. {}{}",
            text.origin(declaration.path),
            entry_in_words(declaration.path),
            entry_name(declaration.path),
            subsection.empty() ? "" : " in \"subsection " + subsection + "\"",
            declaration.allowed_text(),
            declaration.meaning_text()));
        }
    throw_problems(problems);
  }



  std::string
  InputFile::file_beside(const std::string &name) const
  {
    return (std::filesystem::path(filename).parent_path() / name).string();
  }
} // namespace seiche
