// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_frame_series_h
#define seiche_postprocess_frame_series_h

#include <mpi.h>

#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace seiche
{
  template <int patch_dim, int dim>
  class FieldPatches;
  class StateArchive;

  /// Where and when output frames are made.
  struct FrameSettings
  {
    std::string directory;
    double      interval = 0.; ///< [s]
    double      end_time = 0.; ///< [s]
  };

  /**
   * @brief Numbered output files at equal intervals of time.
   *
   * The first frame is made at the first call of due(), then one whenever a
   * multiple of the interval has been reached, and one at the end. VTU files
   * get an index NAME.pvd that is rewritten after each frame, so that a run
   * that was killed stays readable. All files go through checked_file; a
   * failure on one rank throws FileError on all.
   */
  class FrameSeries
  {
  public:
    FrameSeries(const std::string   &series_name,
                const FrameSettings &frame_settings,
                const MPI_Comm       mpi_communicator);

    /// True if a frame is to be made at @p time; ask once a step.
    bool
    due(const double time);

    /// Write the frame of @p time [s] as VTU: one file, or one for each rank
    /// that has patches and a PVTU record; none if there are no patches.
    /// Collective.
    template <int patch_dim, int dim>
    void
    write_vtu(const double time, const FieldPatches<patch_dim, dim> &data);

    /// Write the frame as one file NAME_NNNNNN.@p extension: @p write gets its
    /// path on every rank; if it fails on one, FileError on all. Collective.
    void
    write_file(const std::string                              &extension,
               const std::function<void(const std::string &)> &write);

    /// Which frames there are, for a checkpoint. Loading removes the files of
    /// later frames, those with one of the @p extensions, and drops them from
    /// the index. Collective.
    void
    save_or_load(StateArchive                   &archive,
                 const std::vector<std::string> &extensions);

  private:
    /// Remove the files of frames that are not made yet. Rank 0.
    void
    remove_later_frames(const std::vector<std::string> &extensions) const;

    /// Rewrite NAME.pvd. Rank 0.
    void
    write_index() const;

    /// "NAME_000012", and on to the next number; before the first one the
    /// frames of an earlier run, files with the @p extensions, are removed.
    /// Collective.
    std::string
    next_name(const std::vector<std::string> &extensions);

    const std::string   name;
    const FrameSettings settings;
    const MPI_Comm      communicator;

    unsigned int                                frames = 0;
    double                                      next   = 0.; // [s]
    std::vector<std::pair<double, std::string>> index;       // of the PVD
  };
} // namespace seiche

#endif
