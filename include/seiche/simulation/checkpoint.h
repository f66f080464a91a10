// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_checkpoint_h
#define seiche_simulation_checkpoint_h

#include <seiche/points/point_cloud.h>
#include <seiche/postprocess/hdf5_reader.h>
#include <seiche/utilities/state_archive.h>

#include <map>
#include <string>

namespace seiche
{
  /// Entries of a parameter file and their values, by path.
  using ParameterValues = std::map<std::string, std::string>;

  /**
   * @brief A file from which a run can go on: its points, and what else it
   * carries from step to step.
   *
   * An HDF5 file with the columns of the points, sorted by id, and the dataset
   * `state`, the values of a StateArchive. The last line of the file, which
   * HDF5 ignores, holds the length of all before it and its hash, so that a
   * file that is cut short or altered anywhere is recognised.
   */
  class Checkpoint
  {
  public:
    /// Open and verify. FileError says what is wrong with it. Local.
    explicit Checkpoint(const std::string &filename);

    /// Write the points and @p state, what else the run has saved; on the disk
    /// when this returns. Collective.
    template <int dim>
    static void
    write(const std::string     &filename,
          const PointCloud<dim> &points,
          StateArchive          &state,
          const ParameterValues &parameters);

    /// FileError if the entries that must not change differ from @p now.
    void
    require_same_scene(const ParameterValues &now) const;

    /// What the run has saved, to be loaded from.
    StateArchive &
    state() const
    {
      return saved;
    }

    std::size_t
    n_points() const
    {
      return reader.n_rows("id");
    }

    /// Insert those points that lie in own cells. Every rank reads the whole
    /// file, so that nothing has to be sent. Local.
    template <int dim>
    void
    insert_own_points(PointCloud<dim> &points) const;

    const std::string filename;

  private:
    const Hdf5Reader     reader;
    mutable StateArchive saved; // its place of reading changes
    ParameterValues      parameters;
  };

  /// The entries that a run must keep when it goes on: all but those of
  /// output, checkpoints, solver, step size, end time and scores.
  ParameterValues
  fixed_parameters(const ParameterValues &all);
} // namespace seiche

#endif
