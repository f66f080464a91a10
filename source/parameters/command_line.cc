// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/command_line.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/utilities/embedded_files.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace seiche
{
  namespace
  {
    /// All options with what they take, the file first.
    std::string
    usage(const CLI::App &app)
    {
      std::string file, options;
      for (const CLI::Option *option : app.get_options())
        {
          if (option->get_positional())
            {
              file += " " + option->get_name();
              continue;
            }
          const std::string type = option->get_type_name();
          options += " [--" + option->get_lnames().front() +
                     (option->get_items_expected_max() == 0 || type.empty() ?
                        "" :
                        " " + type) +
                     "]" + (option->get_items_expected_max() > 1 ? "..." : "");
        }
      return app.get_name() + file + options;
    }

    [[noreturn]] void
    refuse(const CLI::App &app, const std::string &problem)
    {
      throw InputError("command line: " + problem + " Usage: " + usage(app));
    }

    /// Options must be known; a second file is one too many.
    void
    check_remaining(const CLI::App &app)
    {
      const std::vector<std::string> remaining = app.remaining();
      if (remaining.empty())
        return;
      const std::string &first = remaining.front();
      if (first.empty() || first[0] != '-')
        refuse(app,
               "there is no place for \"" + first +
                 "\"; one parameter file is enough, and a text with blanks "
                 "needs quotes.");
      const std::string        name = first.substr(0, first.find('='));
      std::vector<std::string> known;
      for (const CLI::Option *option : app.get_options())
        for (const std::string &long_name : option->get_lnames())
          known.push_back("--" + long_name);
      const std::string hint = nearest_hint(name, known);
      refuse(app,
             "unknown option \"" + name + "\"" + (hint.empty() ? "." : hint));
    }

    /// What a scene says of itself: the first sentence of its comment.
    std::string
    first_sentence(const std::string &scene)
    {
      std::istringstream lines(scene);
      std::string        line, text;
      std::getline(lines, line); // the licence
      while (std::getline(lines, line) && line.rfind("# ", 0) == 0)
        {
          text += (text.empty() ? "" : " ") + line.substr(2);
          const std::size_t end = (text + " ").find(". ");
          if (end != std::string::npos)
            return text.substr(0, end);
        }
      return text;
    }

    /// Of --example: the scene, or the list of them.
    std::string
    example_text(const CLI::App &app, const std::string &name)
    {
      std::string              list;
      std::vector<std::string> names;
      for (const EmbeddedFile &file : embedded_files("examples"))
        {
          if (name == file.name)
            return file.text;
          names.emplace_back(file.name);
          list += names.back() +
                  std::string(std::max<int>(1, 16 - names.back().size()), ' ') +
                  first_sentence(file.text) + "\n";
        }
      if (!name.empty())
        refuse(app,
               "there is no example \"" + name + "\"" +
                 (nearest_hint(name, names).empty() ?
                    ". Examples: " + quoted_list(names) + "." :
                    nearest_hint(name, names)));
      return list + "\nTo start:  seiche --example " + names.front() +
             " > scene.prm && seiche scene.prm\n";
    }

    constexpr const char *help_footer =
      "To start:\n"
      "  seiche --example dam_break > dam.prm; seiche dam.prm; seiche-plot dam\n"
      "On several ranks: mpirun -n 2 seiche dam.prm\n"
      "\n"
      "Exit codes: 0 finished, 1 internal error, 2 mistake in the input, "
      "3 numerical failure, 4 a file cannot be written or read, 5 stopped "
      "(--restart goes on), 6 fails a verdict.\n";

    /// What the words of the command line are, but for the CommandLine.
    struct Asked
    {
      bool               version = false;
      std::string        example_name;
      const CLI::Option *output  = nullptr;
      const CLI::Option *example = nullptr;
    };

    void
    declare_options(CLI::App &app, CommandLine &result, Asked &asked)
    {
      app
        .add_option("FILE.prm", result.filename, "Parameter file of the scene")
        ->type_name("");
      app
        .add_option("--set",
                    result.overrides,
                    "Change an entry; any number of times")
        ->type_name("\"Subsection/Entry = value\"")
        ->allow_extra_args(false);
      asked.output = app
                       .add_option("--output",
                                   result.output,
                                   "Folder of the results [name of the file]")
                       ->type_name("DIR");
      app.add_flag("--restart",
                   result.restart,
                   "Go on from the newest checkpoint in that folder");
      app
        .add_option("--max-hours",
                    result.max_hours,
                    "Wall time after which the run has stopped with a "
                    "checkpoint")
        ->type_name("H");
      app.add_flag("--validate",
                   result.validate,
                   "Check everything, foretell time and memory, draw the scene "
                   "(DIR.svg); compute nothing");
      app.add_flag("--print-parameters",
                   result.print_parameters,
                   "Describe all entries of parameter files (markdown)");
      asked.example =
        app
          .add_option("--example",
                      asked.example_name,
                      "Print a commented scene to start from; without NAME: "
                      "list them")
          ->type_name("[NAME]")
          ->expected(0, 1);
      app.add_flag("--self-test",
                   result.self_test,
                   "Say within half a minute whether this build computes what "
                   "it should");
      app.add_flag("--version",
                   asked.version,
                   "Print the versions of program and libraries");
    }

    /// What has a text or scenes of its own takes no other scene.
    void
    refuse_scenes(const CLI::App    &app,
                  const CommandLine &result,
                  const Asked       &asked)
    {
      if (asked.example->count() > 0 && (result.validate || result.restart))
        refuse(app,
               "--example prints a scene, and that is all: write it to a file "
               "first.");
      if (result.self_test && !result.filename.empty())
        refuse(app,
               "--self-test has scenes of its own: leave out \"" +
                 result.filename + "\".");
    }

    void
    require_scene(const CLI::App    &app,
                  const CommandLine &result,
                  const Asked       &asked)
    {
      if (result.filename.empty())
        refuse(app, "no parameter file is given.");
      if (!(result.max_hours > 0.))
        refuse(app, "--max-hours needs a time greater than zero [h].");
      if (asked.output->count() > 0 && result.output.empty())
        refuse(app, "--output needs the name of a folder.");
    }
  } // namespace



  CommandLine
  parse_command_line(const int argc, char **argv)
  {
    CommandLine result;
    Asked       asked;
    CLI::App    app("Incompressible free-surface flow by the material point "
                    "method.",
                 "seiche");
    app.allow_extras();
    declare_options(app, result, asked);
    app.footer(help_footer);

    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::CallForHelp &)
      {
        result.text = app.help();
        return result;
      }
    catch (const CLI::ParseError &error)
      {
        refuse(app, std::string(error.what()) + ".");
      }

    check_remaining(app);
    if (asked.version)
      result.text = version_text();
    else if (asked.example->count() > 0)
      result.text = example_text(app, asked.example_name);
    refuse_scenes(app, result, asked);
    if (!result.text.empty() || result.print_parameters || result.self_test)
      return result;
    require_scene(app, result, asked);
    if (result.output.empty())
      result.output = std::filesystem::path(result.filename).stem().string();
    return result;
  }
} // namespace seiche
