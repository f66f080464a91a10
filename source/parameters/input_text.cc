// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/input_text.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace seiche
{
  using dealii::Utilities::trim;

  std::string
  problem_of_name(const std::string &name)
  {
    return name.find_first_of("/.,;\"") == std::string::npos ?
             "" :
             ": the name of subsection \"" + name +
               "\" has one of / . , ; \" in it; leave them out.";
  }

  std::string
  path_of_names(const std::vector<std::string> &names)
  {
    std::string path;
    for (const std::string &name : names)
      path += (path.empty() ? "" : "/") + name;
    return path;
  }



  void
  InputText::add_subsection(const std::string &path, const std::string &origin)
  {
    for (std::size_t slash = path.find('/');; slash = path.find('/', slash + 1))
      {
        const std::string part = path.substr(0, slash);
        if (subsections.emplace(part, origin).second)
          order.push_back(part);
        if (slash == std::string::npos)
          return;
      }
  }



  void
  InputText::set(const std::vector<std::string> &names,
                 const std::string              &value,
                 const std::string              &origin)
  {
    const std::vector<std::string> around(names.begin(), names.end() - 1);
    for (const std::string &name : around)
      if (const std::string problem = problem_of_name(name); !problem.empty())
        throw InputError(origin + problem);
    if (!around.empty())
      add_subsection(path_of_names(around), origin);
    const std::string path = path_of_names(names);
    if (entries.count(path) == 0)
      order.push_back(path);
    entries[path] = {value, origin, 0};
  }



  std::string
  InputText::origin(const std::string &path) const
  {
    const auto entry = entries.find(path);
    if (entry != entries.end())
      return entry->second.origin;
    for (std::string part = path; !part.empty(); part = subsection_name(part))
      {
        const auto subsection = subsections.find(part);
        if (subsection != subsections.end())
          return subsection->second;
      }
    return end;
  }



  namespace
  {
    /// The names of a path "Subsection/Entry"; none if one is empty.
    std::vector<std::string>
    parts_of(const std::string &path)
    {
      std::vector<std::string> names;
      for (std::size_t begin = 0; begin <= path.size();)
        {
          const std::size_t end = std::min(path.find('/', begin), path.size());
          names.push_back(trim(path.substr(begin, end - begin)));
          if (names.back().empty())
            return {};
          begin = end + 1;
        }
      return names;
    }
  } // namespace



  void
  apply_overrides(const std::vector<std::string> &overrides, InputText &text)
  {
    std::map<std::string, std::string> given;
    for (const std::string &override_text : overrides)
      {
        const std::string origin    = "--set \"" + override_text + "\"";
        const std::size_t equals    = override_text.find('=');
        const std::string path_text = override_text.substr(0, equals);
        const std::vector<std::string> names = parts_of(path_text);
        if (equals == std::string::npos || names.empty())
          throw InputError(origin +
                           ": write --set \"Subsection/Entry = value\".");

        const std::string path = path_of_names(names);
        if (text.subsections.count(path) > 0)
          throw InputError(origin + ": \"" + path +
                           "\" is a subsection; write --set \"" + path +
                           "/Entry = value\".");
        const auto [first, is_new] = given.emplace(path, origin);
        if (!is_new)
          throw InputError(origin + ": entry \"" + names.back() +
                           "\" is set twice, first by " + first->second +
                           "; remove one.");
        text.set(names, trim(override_text.substr(equals + 1)), origin);
      }
  }



  InputText
  read_entries(const SceneEntries &entries)
  {
    InputText text;
    text.end = "program";
    for (const auto &[path, value] : entries.entries())
      {
        const std::string              origin = "program:" + path;
        const std::vector<std::string> names  = parts_of(path);
        if (names.empty())
          throw InputError(origin + ": write \"Subsection/Entry\".");
        if (text.entries.count(path_of_names(names)) > 0)
          throw InputError(origin + ": the entry is set twice; remove one.");
        text.set(names, trim(value), origin);
      }
    return text;
  }
} // namespace seiche
