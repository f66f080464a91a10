// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_stop_signal_h
#define seiche_utilities_stop_signal_h

namespace seiche
{
  /**
   * @brief SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGXCPU and SIGPIPE ask the run to
   * stop at its next step.
   *
   * SIGUSR1 is the one that Open MPI's mpirun hands on to the ranks without
   * killing them soon after; SIGXCPU comes at a limit of processor time,
   * SIGPIPE if nobody reads the output any more.
   */
  namespace stop_signal
  {
    /// From now on the first such signal is noted; a second one kills, if it is
    /// none that comes again by itself. What is ignored stays so. Local.
    void
    install();

    /// Whether this process has got one. Local.
    bool
    received();

    /// From now on they do nothing: the run has ended, and its exit code
    /// counts. Local.
    void
    ignore();
  } // namespace stop_signal
} // namespace seiche

#endif
