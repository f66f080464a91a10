// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_waiting_rank_h
#define seiche_utilities_waiting_rank_h

namespace seiche
{
  /**
   * @brief From MPI_Init on a rank that waits for others sleeps after a while.
   *
   * Open MPI polls without an end, or calls sched_yield() between polls
   * (mpi_yield_when_idle). Where there are more processes than processors
   * either uses up the rank's share of time, and when its message is there it
   * has to queue for each of the thousands of exchanges of a step. This turns
   * the yielding on and replaces sched_yield(), in this program: nothing for
   * the first moment, as messages between free processors need, then short
   * sleeps if the machine has more to run than processors. Measured:
   * doc/scaling.md. What the user has set stays.
   */
  void
  let_waiting_ranks_sleep();
} // namespace seiche

#endif
