// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_run_h
#define seiche_simulation_run_h

#include <seiche/parameters/command_line.h>
#include <seiche/parameters/input_file.h>
#include <seiche/utilities/exceptions.h>

#include <string>

namespace seiche
{
  /**
   * Read the scene from the file, check it and, unless it is only to be
   * validated, run it: lock the output folder, write parameters.prm, simulate.
   * Errors are thrown: InputError before anything is written. Collective.
   */
  template <int dim>
  ExitCode
  run(const CommandLine &command_line, const InputFile &input);

  /// The manual of all entries (--print-parameters). Local.
  std::string
  parameter_text();
} // namespace seiche

#endif
