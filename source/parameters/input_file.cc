// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
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

    /// `entry "E" in "S"`.
    std::string
    entry_in_words(const std::string &path)
    {
      const std::string subsection = subsection_name(path);
      return "entry \"" + entry_name(path) + "\"" +
             (subsection.empty() ? "" : " in \"" + subsection + "\"");
    }

    /// `Allowed: a number >= 0 [Pa].` for the messages.
    std::string
    allowed_in_words(const Declaration &declaration)
    {
      const std::string unit = declaration.unit();
      return "Allowed: " + declaration.allowed() +
             (unit.empty() ? "" : " " + unit) + ".";
    }

    /// ` Meaning: Density of the fluid.`, without the unit at the end.
    std::string
    meaning_in_words(const Declaration &declaration)
    {
      std::string text     = declaration.text;
      const auto  trim_end = [&text]() {
        while (!text.empty() && (text.back() == '.' || text.back() == ' '))
          text.pop_back();
      };
      trim_end();
      const std::string unit = declaration.unit();
      if (!unit.empty() && text.size() > unit.size() &&
          text.compare(text.size() - unit.size(), unit.size(), unit) == 0)
        {
          text.resize(text.size() - unit.size());
          trim_end();
        }
      return text.empty() ? "" : " Meaning: " + text + ".";
    }

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
             allowed_in_words(declaration) + meaning_in_words(declaration);
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
    const std::string place = origin(path);
    const bool        is_included =
      place.rfind(filename + ":", 0) != 0 && place.rfind("--set", 0) != 0;
    if (is_included)
      return;
    const std::string text = place + ": " + entry_in_words(path) + " = " +
                             value(path) + " has no effect: only with " +
                             reader + " is it read";
    if (std::find(set_in_vain.begin(), set_in_vain.end(), text) ==
        set_in_vain.end())
      set_in_vain.push_back(text);
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



  std::string
  InputFile::origin(const std::string &path) const
  {
    const auto entry = text.entries.find(path);
    if (entry != text.entries.end())
      return entry->second.origin;
    for (std::string part = path; !part.empty(); part = subsection_name(part))
      {
        const auto subsection = text.subsections.find(part);
        if (subsection != text.subsections.end())
          return subsection->second;
      }
    return text.end;
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
    throw InputError(origin(path) + ": " + what + ": " + problem);
  }



  void
  InputFile::parse_into(dealii::ParameterHandler &prm) const
  {
    declare_dimension(prm);
    const std::vector<Declaration> known = declarations(prm);

    std::vector<std::string> problems;
    check_names(known, problems);
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
              problems.push_back(origin(path) + ": " + entry_in_words(path) +
                                 " = " + value + ": " + problem);
          }
    for (const Declaration &declaration : known)
      if (declaration.mandatory && text.entries.count(declaration.path) == 0)
        {
          const std::string subsection = subsection_name(declaration.path);
          problems.push_back(fmt::format(
            "{}: {} is mandatory and not set; write \"set {} = ...\"{}. {}{}",
            origin(declaration.path),
            entry_in_words(declaration.path),
            entry_name(declaration.path),
            subsection.empty() ? "" : " in \"subsection " + subsection + "\"",
            allowed_in_words(declaration),
            meaning_in_words(declaration)));
        }
    throw_problems(problems);
  }



  void
  InputFile::check_names(const std::vector<Declaration> &known,
                         std::vector<std::string>       &problems) const
  {
    std::set<std::string> known_entries, known_subsections;
    for (const Declaration &declaration : known)
      {
        known_entries.insert(declaration.path);
        for (std::string part = subsection_name(declaration.path);
             !part.empty();
             part = subsection_name(part))
          known_subsections.insert(part);
      }
    for (const std::string &path : text.order)
      {
        const std::string subsection = subsection_name(path);
        // what is in an unknown subsection is reported with it
        if (!subsection.empty() && known_subsections.count(subsection) == 0)
          continue;
        if (text.subsections.count(path) > 0)
          {
            if (known_subsections.count(path) == 0)
              problems.push_back(unknown_subsection(path, known_subsections));
          }
        else if (known_entries.count(path) == 0)
          problems.push_back(unknown_entry(path, known));
      }
  }



  bool
  InputFile::is_instance(const std::string &subsection) const
  {
    return std::any_of(kinds.begin(), kinds.end(), [&](const auto &kind) {
      return subsection.compare(0, kind.size() + 1, kind + " ") == 0;
    });
  }



  std::string
  InputFile::unknown_subsection(const std::string           &path,
                                const std::set<std::string> &known) const
  {
    const std::string place = origin(path) + ": ";
    if (kinds.count(path) > 0)
      return place + "subsection \"" + path +
             "\" needs a name of its own; write \"subsection " + path +
             " NAME\".";

    const std::string        parent = subsection_name(path);
    const std::string        name   = entry_name(path);
    std::vector<std::string> shown;
    for (const std::string &subsection : known)
      if (subsection_name(subsection) == parent && !is_instance(subsection))
        shown.push_back(entry_name(subsection));
    std::string hint = nearest_hint(name, shown);
    if (parent.empty())
      for (const std::string &kind : kinds)
        {
          shown.push_back(kind + " NAME");
          // as many first words of the name as the kind has
          std::size_t end = 0;
          for (long n = std::count(kind.begin(), kind.end(), ' ') + 1;
               n > 0 && end != std::string::npos;
               --n)
            end = name.find(' ', end + 1);
          if (end != std::string::npos &&
              edit_distance(name.substr(0, end), kind) <=
                std::max<std::size_t>(2, kind.size() / 4))
            hint = "; did you mean \"" + kind + name.substr(end) + "\"?";
        }
    return place + "no subsection \"" + name + "\"" +
           (parent.empty() ? "" : " in \"" + parent + "\"") +
           (hint.empty() ?
              ". Subsections there: " +
                (shown.empty() ? "none" : quoted_list(shown)) + "." :
              hint);
  }



  std::string
  InputFile::unknown_entry(const std::string              &path,
                           const std::vector<Declaration> &known) const
  {
    const std::string        name   = entry_name(path);
    const std::string        parent = subsection_name(path);
    std::vector<std::string> siblings;
    std::string              elsewhere;
    for (const Declaration &declaration : known)
      if (subsection_name(declaration.path) == parent)
        siblings.push_back(entry_name(declaration.path));
      else if (entry_name(declaration.path) == name && elsewhere.empty() &&
               !is_instance(subsection_name(declaration.path)))
        elsewhere = subsection_name(declaration.path);

    std::string message =
      origin(path) + ": no entry \"" + name + "\"" +
      (parent.empty() ? " outside subsections" : " in \"" + parent + "\"");
    const std::string nearest = nearest_name(name, siblings);
    if (!nearest.empty())
      for (const Declaration &declaration : known)
        if (declaration.path == (parent.empty() ? "" : parent + "/") + nearest)
          return message + "; did you mean \"" + nearest + "\" " +
                 declaration.unit() + "? " + allowed_in_words(declaration);
    if (!elsewhere.empty())
      return message + "; it belongs into \"subsection " + elsewhere + "\".";
    return message + ". Entries there: " + quoted_list(siblings) + ".";
  }



  std::string
  InputFile::file_beside(const std::string &name) const
  {
    return (std::filesystem::path(filename).parent_path() / name).string();
  }
} // namespace seiche
