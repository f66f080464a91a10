// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_summary_file_h
#define seiche_simulation_summary_file_h

#include <seiche/utilities/timer_tree.h>

#include <mpi.h>
#include <nlohmann/json.hpp>

namespace seiche
{
  /**
   * The summary of a run as other programs read it: the keys in their fixed
   * order (null where the run gave none), then further keys of the run.
   *
   * Added here: program_version, ranks, cpu_seconds and phase_seconds
   * (processor seconds, sum over ranks), wall_seconds (largest of all ranks),
   * peak_memory_mib (sum of the largest resident sizes of the ranks), status.
   * JSON has no word for numbers that are not finite: they become null, and
   * "not_finite" lists them by name ("errors/front_rms": "nan"). Collective;
   * the result is complete on rank 0 only.
   */
  nlohmann::ordered_json
  complete_summary(const nlohmann::ordered_json &summary,
                   const TimerTree              &timer,
                   const MPI_Comm                communicator);
} // namespace seiche

#endif
