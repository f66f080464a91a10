// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_accepted_failures_h
#define seiche_simulation_accepted_failures_h

#include <seiche/simulation/run_report.h>
#include <seiche/solve/newton.h>

#include <array>
#include <cstdint>

namespace seiche
{
  /**
   * @brief What was taken although it had failed, with Time/Failing steps =
   * accepted: steps that had not converged, points that were held back.
   */
  class AcceptedFailures
  {
  public:
    /// After a step that was taken at @p time [s]; @p n_held points of this
    /// rank were held back. Warns. Collective.
    void
    account(const NewtonResult &newton,
            const std::size_t   n_held,
            const double        time,
            const MPI_Comm      communicator,
            RunReport          &report);

    /// Names of the counts in summary.json.
    static constexpr std::array<const char *, 2> summary_numbers = {
      {"accepted_failing_steps", "points_held_back"}};

    /// The counts, for summary.json.
    void
    summarize(nlohmann::ordered_json &summary) const;

    /// Local.
    void
    save_or_load(StateArchive &archive);

  private:
    std::uint64_t steps = 0, points = 0;
  };
} // namespace seiche

#endif
