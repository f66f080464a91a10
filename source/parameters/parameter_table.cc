// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/parameter_table.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    /// Text for a cell of a table.
    std::string
    cell(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        if (c == '|')
          result += "\\|";
        else
          result += (c == '\n' ? ' ' : c);
      return result;
    }

    const Declaration *
    find(const std::vector<Declaration> &declarations, const std::string &path)
    {
      const auto entry = std::find_if(declarations.begin(),
                                      declarations.end(),
                                      [&](const Declaration &declaration) {
                                        return declaration.path == path;
                                      });
      return entry == declarations.end() ? nullptr : &*entry;
    }

    std::string
    shown_default(const Declaration &declaration)
    {
      if (declaration.mandatory)
        return "**mandatory**";
      return declaration.default_value.empty() ?
               "" :
               "`" + cell(declaration.default_value) + "`";
    }

    /// What differs between 2D and 3D is shown for both.
    template <typename Function>
    std::string
    both(const Declaration *in_2d,
         const Declaration *in_3d,
         const Function    &property)
    {
      if (in_2d == nullptr || in_3d == nullptr)
        return property(in_2d == nullptr ? *in_3d : *in_2d);
      const std::string text_2d = property(*in_2d), text_3d = property(*in_3d);
      return text_2d == text_3d ? text_2d :
                                  text_2d + " (2D), " + text_3d + " (3D)";
    }

    std::string
    row(const Declaration *in_2d, const Declaration *in_3d)
    {
      const std::string path = (in_2d == nullptr ? in_3d : in_2d)->path;
      const std::string only = in_2d == nullptr ? " (3D only)" :
                               in_3d == nullptr ? " (2D only)" :
                                                  "";
      return "| `" + entry_name(path) + "`" + only + " | " +
             both(in_2d, in_3d, shown_default) + " | " +
             both(in_2d,
                  in_3d,
                  [](const Declaration &declaration) {
                    return cell(declaration.allowed());
                  }) +
             " | " +
             both(in_2d,
                  in_3d,
                  [](const Declaration &declaration) {
                    return cell(declaration.text);
                  }) +
             " |\n";
    }
  } // namespace



  std::string
  parameter_table(const std::vector<Declaration> &in_2d,
                  const std::vector<Declaration> &in_3d)
  {
    // the order of the 3D scene, which has more entries, then those of 2D only
    std::vector<Declaration> all = in_3d;
    for (const Declaration &declaration : in_2d)
      if (find(in_3d, declaration.path) == nullptr)
        all.push_back(declaration);
    std::vector<std::string> subsections;
    for (const Declaration &declaration : all)
      {
        const std::string name = subsection_name(declaration.path);
        if (std::find(subsections.begin(), subsections.end(), name) ==
            subsections.end())
          subsections.push_back(name);
      }

    std::string text =
      "# Entries of a parameter file\n\n"
      "This text is the output of `seiche --print-parameters`. Subsections "
      "whose title ends with NAME may occur any number of times, each with a "
      "name of its own. All quantities are in SI units; the unit of an entry "
      "stands in brackets.\n";
    for (const std::string &subsection : subsections)
      {
        text += subsection.empty() ? "\n## Outside subsections\n\n" :
                                     "\n## Subsection " + subsection + "\n\n";
        text += "| entry | default | allowed | meaning |\n"
                "|---|---|---|---|\n";
        for (const Declaration &declaration : all)
          if (subsection_name(declaration.path) == subsection)
            text +=
              row(find(in_2d, declaration.path), find(in_3d, declaration.path));
      }
    return text;
  }
} // namespace seiche
