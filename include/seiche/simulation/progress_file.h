// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_progress_file_h
#define seiche_simulation_progress_file_h

#include <string>

namespace seiche
{
  /**
   * @brief progress.json in the output folder, for who watches a run: written at
   * most once a second, and at its end.
   */
  class ProgressFile
  {
  public:
    /// @p output_directory: empty: no file.
    explicit ProgressFile(const std::string &output_directory);

    struct Values
    {
      double time         = 0.; ///< [s], as all that follow
      double end_time     = 0.;
      double dt           = 0.;
      double seconds_left = 0.; ///< of wall time; not finite: unknown
    };

    /// A step is done at @p wall_time [s]. FileError. Rank 0.
    void
    update(const Values &now, const double wall_time);

    /// The run is "finished", "stopped" or has "failed". FileError. Rank 0.
    void
    end(const std::string &state);

  private:
    void
    write(const std::string &state) const;

    const std::string directory;
    Values            values;
    double            written = -1.; ///< wall time [s]
  };
} // namespace seiche

#endif
