// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_lines.h>
#include <seiche/parameters/input_problems.h>
#include <seiche/parameters/input_reader.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <filesystem>

namespace seiche
{
  namespace
  {
    namespace fs = std::filesystem;
    using dealii::Utilities::trim;

    constexpr unsigned int most_files = 100;
    constexpr std::size_t  deepest    = 8; // subsections in each other

    /// True if the line starts with the word, which is then removed.
    bool
    take_word(std::string &line, const std::string &word)
    {
      if (line.compare(0, word.size(), word) != 0 ||
          (line.size() > word.size() && line[word.size()] != ' ' &&
           line[word.size()] != '\t'))
        return false;
      line = trim(line.substr(word.size()));
      return true;
    }

    /// The reader of one file and those it includes.
    class Reader
    {
    public:
      InputText                text;
      std::vector<std::string> problems;

      void
      read(const std::string &filename, const std::string &included_at);

    private:
      /// False if the file includes itself or is one too many: a problem.
      bool
      may_be_read(const fs::path &canonical, const std::string &place);
      void
      read_line(std::string        line,
                const std::string &origin,
                const std::string &filename,
                const std::size_t  outer_depth);
      void
      open_subsection(const std::string &name, const std::string &origin);
      void
      set_entry(const std::string &line, const std::string &origin);

      struct OpenSubsection
      {
        std::string name, origin;
      };

      std::string
      path_of(const std::string &entry) const
      {
        std::vector<std::string> names;
        for (const auto &subsection : open)
          names.push_back(subsection.name);
        names.push_back(entry);
        return path_of_names(names);
      }

      std::vector<OpenSubsection> open;
      std::vector<fs::path>       files; // being read, outermost first
      unsigned int                n_files = 0;
    };



    bool
    Reader::may_be_read(const fs::path &canonical, const std::string &place)
    {
      for (const fs::path &file : files)
        if (file == canonical)
          {
            problems.push_back(place + ": the file includes itself; remove "
                                       "this include.");
            return false;
          }
      if (++n_files > most_files)
        {
          problems.push_back(fmt::format("{}: more than {} files are included",
                                         place,
                                         most_files));
          return false;
        }
      return true;
    }



    void
    Reader::read(const std::string &filename, const std::string &included_at)
    {
      const std::string place =
        included_at.empty() ? filename : included_at + ": \"" + filename + "\"";
      std::error_code error;
      const fs::path  canonical = fs::weakly_canonical(filename, error);
      if (!may_be_read(canonical, place))
        return;
      const InputLines contents = read_lines(filename);
      if (!contents.problem.empty())
        {
          problems.push_back(place + ": " + contents.problem + ".");
          return;
        }

      files.push_back(canonical);
      const std::size_t outer_depth = open.size();
      for (const InputLine &line : contents.lines)
        read_line(line.text,
                  fmt::format("{}:{}", filename, line.number),
                  filename,
                  outer_depth);
      text.end = fmt::format("{}:{}", filename, contents.n_lines);
      while (open.size() > outer_depth)
        {
          problems.push_back(
            fmt::format("{}: subsection \"{}\" has no \"end\".",
                        open.back().origin,
                        open.back().name));
          open.pop_back();
        }
      files.pop_back();
    }



    void
    Reader::read_line(std::string        line,
                      const std::string &origin,
                      const std::string &filename,
                      const std::size_t  outer_depth)
    {
      if (line.empty())
        return;
      const std::string whole = line;
      if (take_word(line, "subsection") || take_word(line, "SUBSECTION"))
        open_subsection(line, origin);
      else if (take_word(line, "end") || take_word(line, "END"))
        {
          if (!line.empty())
            problems.push_back(origin + ": \"" + line +
                               "\" after \"end\"; write it on its own line.");
          if (open.size() > outer_depth)
            open.pop_back();
          else
            problems.push_back(origin +
                               ": \"end\" without an open subsection in this "
                               "file; remove it.");
        }
      else if (take_word(line, "set") || take_word(line, "SET"))
        set_entry(line, origin);
      else if (take_word(line, "include") || take_word(line, "INCLUDE"))
        {
          if (line.size() > 1 && line.front() == '"' && line.back() == '"')
            line = line.substr(1, line.size() - 2);
          if (line.empty())
            problems.push_back(origin + ": \"include\" needs a file name.");
          else
            read((fs::path(filename).parent_path() / line).string(), origin);
        }
      else
        {
          const std::string word = whole.substr(0, whole.find_first_of(" \t="));
          problems.push_back(fmt::format(
            "{}: cannot read \"{}\"{} A line is \"subsection "
            "NAME\", \"set NAME = VALUE\", \"end\", \"include "
            "FILE\" or a comment from # on.",
            origin,
            whole.substr(0, 80),
            nearest_name(word, {"subsection", "set", "end", "include"})
                .empty() ?
              "." :
              nearest_hint(word, {"subsection", "set", "end", "include"})));
        }
    }



    void
    Reader::open_subsection(const std::string &name, const std::string &origin)
    {
      if (name.empty())
        problems.push_back(origin + ": \"subsection\" needs a name.");
      else if (const std::string problem = problem_of_name(name);
               !problem.empty())
        problems.push_back(origin + problem);
      const std::string path = path_of(name);
      open.push_back({name, origin});
      if (open.size() == deepest + 1)
        problems.push_back(fmt::format("{}: more than {} subsections stand in "
                                       "each other; scenes have one level.",
                                       origin,
                                       deepest));
      if (open.size() <= deepest)
        text.add_subsection(path, origin);
    }



    void
    Reader::set_entry(const std::string &line, const std::string &origin)
    {
      if (open.size() > deepest)
        return; // reported
      const std::size_t equals = line.find('=');
      const std::string name   = trim(line.substr(0, equals));
      if (equals == std::string::npos || name.empty())
        {
          problems.push_back(fmt::format(
            "{}: cannot read \"set {}\"; write \"set NAME = VALUE\".",
            origin,
            line.substr(0, 80)));
          return;
        }
      const std::string  path  = path_of(name);
      const unsigned int depth = files.size() - 1;
      const auto         known = text.entries.find(path);
      if (known == text.entries.end())
        text.order.push_back(path);
      else if (known->second.depth <= depth)
        {
          problems.push_back(fmt::format(
            "{}: entry \"{}\"{} is set twice, first at {}; remove one.",
            origin,
            name,
            open.empty() ? "" : " in \"" + open.back().name + "\"",
            known->second.origin));
          return;
        }
      text.entries[path] = {trim(line.substr(equals + 1)), origin, depth};
    }
  } // namespace



  InputText
  read_input(const std::string &filename)
  {
    Reader reader;
    reader.read(filename, "");
    throw_problems(reader.problems);
    if (reader.text.entries.empty())
      throw InputError(reader.text.end +
                       ": the file sets no entry; a scene needs at least \"set "
                       "Dimension = 2\" and its mandatory entries.");
    return reader.text;
  }
} // namespace seiche
