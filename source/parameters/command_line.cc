// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/config.h>

#include <seiche/parameters/command_line.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/version.h>

#include <CLI/CLI.hpp>

#include <filesystem>

namespace seiche
{
  namespace
  {
    std::string
    version_text()
    {
      return std::string("seiche ") + program_version + " (deal.II " +
             DEAL_II_PACKAGE_VERSION + ")\n";
    }

    [[noreturn]] void
    refuse(const std::string &problem)
    {
      throw InputError(
        "command line: " + problem +
        " Usage: seiche FILE.prm [--set \"Subsection/Entry = "
        "value\"]... [--output DIR] [--restart] [--max-hours H] [--validate] "
        "[--print-parameters] [--version] [--help]");
    }

    /// Options must be known; a second file is one too many.
    void
    check_remaining(const std::vector<std::string> &remaining)
    {
      if (remaining.empty())
        return;
      const std::string &first = remaining.front();
      if (first.empty() || first[0] != '-')
        refuse("there is no place for \"" + first +
               "\"; one parameter file is enough, and a text with blanks "
               "needs quotes.");
      const std::string name = first.substr(0, first.find('='));
      const std::string hint = nearest_hint(name,
                                            {"--set",
                                             "--output",
                                             "--restart",
                                             "--max-hours",
                                             "--validate",
                                             "--print-parameters",
                                             "--version",
                                             "--help"});
      refuse("unknown option \"" + name + "\"" + (hint.empty() ? "." : hint));
    }
  } // namespace



  CommandLine
  parse_command_line(const int argc, char **argv)
  {
    CommandLine result;
    bool        version = false;

    CLI::App app("Incompressible free-surface flow by the material point "
                 "method.",
                 "seiche");
    app.allow_extras();
    app.add_option("FILE.prm", result.filename, "Parameter file of the scene");
    app
      .add_option("--set",
                  result.overrides,
                  "Change an entry: \"Subsection/Entry = value\"")
      ->allow_extra_args(false);
    CLI::Option *output =
      app.add_option("--output",
                     result.output,
                     "Folder of the results [name of the file]");
    app.add_flag("--restart",
                 result.restart,
                 "Go on from the newest checkpoint in that folder");
    app.add_option("--max-hours",
                   result.max_hours,
                   "Wall time after which the run has stopped with a "
                   "checkpoint");
    app.add_flag("--validate",
                 result.validate,
                 "Check everything, foretell time and memory, draw the scene "
                 "(DIR.svg); compute nothing");
    app.add_flag("--print-parameters",
                 result.print_parameters,
                 "Describe all entries of parameter files (markdown)");
    app.add_flag("--version", version, "Print the version");

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
        refuse(std::string(error.what()) + ".");
      }

    check_remaining(app.remaining());
    if (version)
      result.text = version_text();
    if (version || result.print_parameters)
      return result;
    if (result.filename.empty())
      refuse("no parameter file is given.");
    if (!(result.max_hours > 0.))
      refuse("--max-hours needs a time greater than zero [h].");
    if (output->count() > 0 && result.output.empty())
      refuse("--output needs the name of a folder.");
    if (result.output.empty())
      result.output = std::filesystem::path(result.filename).stem().string();
    return result;
  }
} // namespace seiche
