// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_stop_signal_h
#define seiche_utilities_stop_signal_h

namespace seiche
{
  /**
   * @brief SIGTERM, SIGINT and SIGUSR1 ask the run to stop at its next step.
   *
   * SIGUSR1 is the one that Open MPI's mpirun hands on to the ranks without
   * killing them soon after.
   */
  namespace stop_signal
  {
    /// From now on the first such signal is noted; a second one kills. Local.
    void
    install();

    /// Whether this process has got one. Local.
    bool
    received();
  } // namespace stop_signal
} // namespace seiche

#endif
