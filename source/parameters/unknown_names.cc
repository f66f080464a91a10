// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/nearest_name.h>
#include <seiche/parameters/unknown_names.h>

#include <algorithm>

namespace seiche
{
  std::vector<std::string>
  UnknownNames::problems() const
  {
    std::vector<std::string> problems;
    std::set<std::string>    known_entries, known_subsections;
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
          problems.push_back(unknown_entry(path));
      }
    return problems;
  }



  bool
  UnknownNames::is_instance(const std::string &subsection) const
  {
    return std::any_of(kinds.begin(), kinds.end(), [&](const auto &kind) {
      return subsection.compare(0, kind.size() + 1, kind + " ") == 0;
    });
  }



  std::string
  UnknownNames::unknown_subsection(
    const std::string           &path,
    const std::set<std::string> &subsections) const
  {
    const std::string place = text.origin(path) + ": ";
    if (kinds.count(path) > 0)
      return place + "subsection \"" + path +
             "\" needs a name of its own; write \"subsection " + path +
             " NAME\".";

    const std::string        parent = subsection_name(path);
    const std::string        name   = entry_name(path);
    std::vector<std::string> shown;
    for (const std::string &subsection : subsections)
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
  UnknownNames::unknown_entry(const std::string &path) const
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
      text.origin(path) + ": no entry \"" + name + "\"" +
      (parent.empty() ? " outside subsections" : " in \"" + parent + "\"");
    const std::string nearest = nearest_name(name, siblings);
    if (!nearest.empty())
      for (const Declaration &declaration : known)
        if (declaration.path == (parent.empty() ? "" : parent + "/") + nearest)
          return message + "; did you mean \"" + nearest + "\" " +
                 declaration.unit() + "? " + declaration.allowed_text();
    if (!elsewhere.empty())
      return message + "; it belongs into \"subsection " + elsewhere + "\".";
    return message + ". Entries there: " + quoted_list(siblings) + ".";
  }
} // namespace seiche
