// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_stepped_run_h
#define seiche_simulation_stepped_run_h

#include <seiche/parameters/scene_entries.h>

#include <cstddef>
#include <memory>
#include <string>

namespace seiche
{
  template <int dim>
  class PointCloud;
  template <int dim>
  class Problem;

  /**
   * @brief A run for a program that has no parameter file and takes the steps
   * itself: examples/column.cc.
   *
   * Writes the same files as the program into its folder (no checkpoints) and
   * prints warnings only. MPI has to be initialised; everything is collective.
   * Throws InputError, FileError, NumericalError (utilities/exceptions.h).
   */
  template <int dim>
  class SteppedRun
  {
  public:
    /// Check the scene, make grid and points, up to the first row of
    /// statistics. @p directory: of the results, made if need be; an earlier
    /// run's are moved to DIRECTORY.old.
    SteppedRun(const SceneEntries &scene, const std::string &directory);
    ~SteppedRun();

    /// From time() to the end of a step, whose size is that of the scene's
    /// Time/Step. The step that reaches Time/End time writes the summary;
    /// std::logic_error after it.
    void
    step();

    /// Whether Time/End time is reached, or all fluid has left: the step that
    /// finds that adds no row.
    bool
    finished() const;

    /// [s]
    double
    time() const;

    /// Of the last row of statistics.csv, in the unit that the name of the
    /// column ends with: `value("front surge [m]")`. std::out_of_range with
    /// the names there are for another.
    double
    value(const std::string &column) const;

    /// The material points of this rank: `data(PointColumn::velocity, d)`.
    const PointCloud<dim> &
    points() const;

    /// Grid, points, fill and all else that the method works with.
    const Problem<dim> &
    problem() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace seiche

#endif
