// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_remaining_time_h
#define seiche_simulation_remaining_time_h

#include <seiche/utilities/state_archive.h>

#include <string>

namespace seiche
{
  /// The wall time that a run still needs, by the pace of its last steps.
  class RemainingTime
  {
  public:
    /// @p end_of_run [s]
    explicit RemainingTime(const double end_of_run);

    /// A step has ended at @p time, at @p now on the wall clock [s].
    void
    measure(const double time, const double now);

    /// [s]; not finite: unknown.
    double
    seconds() const;

    /// ", 3 h left"; empty if unknown.
    std::string
    text() const;

    /// " | 3 h left, ends 14:05"; empty at the end, and if unknown.
    std::string
    text_with_end() const;

    /// The time so far, for a checkpoint. Local.
    void
    save_or_load(StateArchive &archive);

  private:
    const double end_time;       // [s]
    double       rate = 0.;      // simulated seconds per wall second
    double       last_wall;      // wall seconds at the last step
    double       last_time = 0.; // [s] simulated time then
  };
} // namespace seiche

#endif
