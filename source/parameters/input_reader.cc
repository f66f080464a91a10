// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_reader.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/regular_file.h>

#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace seiche
{
  namespace
  {
    namespace fs = std::filesystem;
    using dealii::Utilities::trim;

    // A scene is some hundred lines; what is larger is not a scene.
    constexpr std::uintmax_t largest_file = 16u << 20;
    constexpr unsigned int   most_files   = 100;
    constexpr std::size_t    most_shown   = 20;
    constexpr std::size_t    deepest      = 8; // subsections in each other

    /// The whole file; the problem as text if it cannot be one of ours.
    std::string
    file_contents(const std::string &filename, std::string &problem)
    {
      problem = problem_of_file(filename, largest_file);
      if (!problem.empty())
        return "";

      // the stream's own read() reports what the system refuses to read
      std::ifstream          stream(filename, std::ios::binary);
      std::string            text;
      std::array<char, 4096> block;
      while (stream.read(block.data(), block.size()) || stream.gcount() > 0)
        text.append(block.data(), stream.gcount());
      if (!stream.eof())
        problem = "this file cannot be read; check its permissions";
      else if (text.find('\0') != std::string::npos)
        problem = "this is not a text file";
      else if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        problem = "this file is empty; a scene needs at least \"set Dimension "
                  "= 2\" and its mandatory entries";
      else if (text.compare(0, 3, "\xEF\xBB\xBF") == 0)
        text.erase(0, 3); // mark of some editors
      return text;
    }

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

    std::string
    problem_of_name(const std::string &name)
    {
      return name.find_first_of("/,;\"") == std::string::npos ?
               "" :
               ": the name of subsection \"" + name +
                 "\" has one of / , ; \" in it; leave them out.";
    }

    std::string
    joined(const std::vector<std::string> &names)
    {
      std::string path;
      for (const std::string &name : names)
        path += (path.empty() ? "" : "/") + name;
      return path;
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
        return joined(names);
      }

      std::vector<OpenSubsection> open;
      std::vector<fs::path>       files; // being read, outermost first
      unsigned int                n_files = 0;
    };



    void
    Reader::read(const std::string &filename, const std::string &included_at)
    {
      const std::string place =
        included_at.empty() ? filename : included_at + ": \"" + filename + "\"";
      std::error_code error;
      const fs::path  canonical = fs::weakly_canonical(filename, error);
      for (const fs::path &file : files)
        if (file == canonical)
          {
            problems.push_back(place + ": the file includes itself; remove "
                                       "this include.");
            return;
          }
      if (++n_files > most_files)
        {
          problems.push_back(fmt::format("{}: more than {} files are included",
                                         place,
                                         most_files));
          return;
        }
      std::string       problem;
      const std::string contents = file_contents(filename, problem);
      if (!problem.empty())
        {
          problems.push_back(place + ": " + problem + ".");
          return;
        }

      files.push_back(canonical);
      const std::size_t outer_depth = open.size();
      std::string       line;
      unsigned int      number = 0, first_number = 0;
      for (std::size_t begin = 0; begin < contents.size();)
        {
          const std::size_t end =
            std::min(contents.find('\n', begin), contents.size());
          std::string piece = contents.substr(begin, end - begin);
          begin             = end + 1;
          ++number;
          if (line.empty())
            first_number = number;
          // a backslash within a comment continues nothing
          piece                = trim(piece.substr(0, piece.find('#')));
          const bool continued = !piece.empty() && piece.back() == '\\';
          if (continued)
            piece.pop_back();
          line += piece;
          if (continued && begin < contents.size())
            continue;
          read_line(trim(line),
                    fmt::format("{}:{}", filename, first_number),
                    filename,
                    outer_depth);
          line.clear();
        }
      while (open.size() > outer_depth)
        {
          problems.push_back(
            fmt::format("{}: subsection \"{}\" has no \"end\".",
                        open.back().origin,
                        open.back().name));
          open.pop_back();
        }
      files.pop_back();
      text.end = fmt::format("{}:{}", filename, number);
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

    /// Set the entry of the last of the names in the subsections of the others.
    void
    set_entry(const std::vector<std::string> &names,
              const std::string              &value,
              const std::string              &origin,
              InputText                      &text)
    {
      const std::vector<std::string> around(names.begin(), names.end() - 1);
      for (const std::string &name : around)
        if (const std::string problem = problem_of_name(name); !problem.empty())
          throw InputError(origin + problem);
      if (!around.empty())
        text.add_subsection(joined(around), origin);
      const std::string path = joined(names);
      if (text.entries.count(path) == 0)
        text.order.push_back(path);
      text.entries[path] = {value, origin, 0};
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

        const std::string path = joined(names);
        if (text.subsections.count(path) > 0)
          throw InputError(origin + ": \"" + path +
                           "\" is a subsection; write --set \"" + path +
                           "/Entry = value\".");
        const auto [first, is_new] = given.emplace(path, origin);
        if (!is_new)
          throw InputError(origin + ": entry \"" + names.back() +
                           "\" is set twice, first by " + first->second +
                           "; remove one.");
        set_entry(names, trim(override_text.substr(equals + 1)), origin, text);
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
        if (text.entries.count(joined(names)) > 0)
          throw InputError(origin + ": the entry is set twice; remove one.");
        set_entry(names, trim(value), origin, text);
      }
    return text;
  }



  void
  throw_problems(const std::vector<std::string> &problems)
  {
    if (problems.empty())
      return;
    std::string message;
    for (std::size_t i = 0; i < std::min(problems.size(), most_shown); ++i)
      message += (i > 0 ? "\n" : "") + problems[i];
    if (problems.size() > most_shown)
      message +=
        fmt::format("\n... and {} more.", problems.size() - most_shown);
    throw InputError(message);
  }
} // namespace seiche
