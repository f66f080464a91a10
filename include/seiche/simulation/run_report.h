// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_run_report_h
#define seiche_simulation_run_report_h

#include <seiche/simulation/progress_file.h>
#include <seiche/simulation/progress_line.h>
#include <seiche/simulation/remaining_time.h>
#include <seiche/simulation/test_log.h>
#include <seiche/utilities/growing_file.h>
#include <seiche/utilities/state_archive.h>
#include <seiche/utilities/timer_tree.h>

#include <mpi.h>
#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace seiche
{
  /**
   * @brief What a run says: screen, run.log, timing.txt, summary.json.
   *
   * Rank 0 prints and writes; calls on other ranks do nothing (finish() is
   * collective). On a terminal one line is overwritten at most once a second;
   * elsewhere one line is printed per 5 % of the simulated time. run.log gets
   * a plain line a step.
   *
   * In test mode only the compact TestLog is printed.
   */
  class RunReport
  {
  public:
    struct Options
    {
      std::string directory;      ///< of the files; empty: no files
      double      end_time  = 0.; ///< [s]
      bool        test_mode = false;
      bool        quiet = false; ///< of what is said, warnings alone are shown
    };

    /// Local.
    RunReport(const Options &options, const MPI_Comm communicator);

    /// Open run.log (and "output" in test mode) and write what was said so
    /// far: until the input is checked, files of an earlier run stay. FileError
    /// if that fails. A run that goes on appends to its run.log. Rank 0.
    void
    open_files(const bool goes_on = false);

    /// Print a text as it is: what is run, how large it is.
    void
    header(const std::string &text);

    /**
     * A step is done.
     *
     * @param time   [s] end of the step
     * @param dt     [s]
     * @param newton iterations of this step, all tries
     * @param krylov iterations of this step, all tries
     * @param energy over its start [-]
     */
    void
    progress(const double       time,
             const double       dt,
             const unsigned int newton,
             const unsigned int krylov,
             const double       energy);

    /// ", 3 h left", by the steps so far; empty if unknown, and in a test.
    std::string
    time_left() const;

    /// Print the first time, count afterwards; @p detail (step, place) is
    /// printed with the first and does not distinguish warnings.
    void
    warn(const std::string &text, const std::string &detail = "");

    /// Print what a user would want to know and what is no warning.
    void
    note(const std::string &text, const std::string &detail = "");

    /// End the progress line and note the reason of a failure in run.log.
    /// Never throws.
    void
    fail(const std::string &text) noexcept;

    /// Warnings and progress so far, for a checkpoint. Local.
    void
    save_or_load(StateArchive &archive);

    /// The last words of a run that was asked to stop.
    void
    stop(const std::string &text);

    /**
     * Add seconds and memory to the summary, write summary.json and
     * timing.txt, print counts of warnings, the timer tree and the last line.
     * Numbers that are not finite become null and are listed by name in
     * "not_finite". Collective.
     */
    void
    finish(const nlohmann::ordered_json &summary, const TimerTree &timer);

  private:
    /// A line for screen and run.log that ends a progress line first.
    void
    print(const std::string &text);
    /// Those of scores, and the counts of all others, which complete the
    /// summary.
    void
    repeat_warnings(nlohmann::ordered_json &complete);
    /// A line for run.log alone.
    void
    write_log(const std::string &text);

    const Options  options;
    const MPI_Comm communicator;
    const bool     speaks; // rank 0

    GrowingFile   log;
    TestLog       test_log;
    ProgressFile  progress_file;
    ProgressLine  progress_line;
    RemainingTime remaining;
    std::string   early_log; // before open_files()

    std::vector<std::pair<std::string, unsigned int>> warnings;

    double last_shown = -1.; // wall seconds
    double last_share = 0.;
  };
} // namespace seiche

#endif
