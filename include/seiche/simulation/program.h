// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_program_h
#define seiche_simulation_program_h

namespace seiche
{
  /// Settings of the process, before MPI is initialised.
  void
  prepare_process();

  /// What the command line asks for; failures are told on standard error.
  /// Returns the exit code. Collective.
  int
  run_program(const int argc, char **argv);
} // namespace seiche

#endif
