// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_parameters_command_line_h
#define seiche_parameters_command_line_h

#include <limits>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief What was typed after `seiche`.
   */
  struct CommandLine
  {
    std::string              filename;  ///< parameter file
    std::vector<std::string> overrides; ///< texts of --set
    std::string output; ///< --output; default: the file's name without ending
    bool        validate         = false;
    bool        restart          = false; ///< from the newest checkpoint
    bool        print_parameters = false;
    /// Wall time [h].
    double max_hours = std::numeric_limits<double>::infinity();
    /// Compute the scenes of the self-test instead of a file's.
    bool self_test = false;
    /// Text of --help, --example or --version: print it and end.
    std::string text;
  };

  /// Read the command line (CLI11). InputError for what it does not know,
  /// with the nearest option. Local.
  CommandLine
  parse_command_line(const int argc, char **argv);
} // namespace seiche

#endif
