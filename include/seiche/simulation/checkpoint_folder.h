// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_checkpoint_folder_h
#define seiche_simulation_checkpoint_folder_h

#include <seiche/simulation/checkpoint.h>
#include <seiche/simulation/run_report.h>

#include <memory>
#include <string>

namespace seiche
{
  /**
   * @brief The checkpoints of an output folder, checkpoint-000120.h5 by the
   * number of the step: the last two are kept, so that one is left whatever
   * happens to the other.
   */
  class CheckpointFolder
  {
  public:
    /// @p parameters: those that must agree (fixed_parameters()).
    CheckpointFolder(const std::string     &directory,
                     const ParameterValues &parameters,
                     const MPI_Comm         communicator);

    /// InputError if the folder has no checkpoint at all; @p hint: where there
    /// may be one. Collective.
    void
    require_any(const std::string &hint) const;

    /// The newest checkpoint of this scene that is sound. Newer ones that are
    /// not are warned of; FileError with what is wrong with each if none is.
    /// Collective.
    std::unique_ptr<Checkpoint>
    newest_usable(RunReport &report);

    /// Remove all checkpoints: a new run begins. Rank 0.
    void
    clear() const;

    /// Write one; then remove all but this and the one before, with a warning
    /// if that cannot be done. Collective.
    template <int dim>
    void
    write(const unsigned int     step,
          const PointCloud<dim> &points,
          StateArchive          &state,
          RunReport             &report);

    /// The one just written, read again. Collective.
    std::unique_ptr<Checkpoint>
    last() const;

  private:
    /// Names of the checkpoints, the newest first. Local.
    std::vector<std::string>
    list() const;

    /// Remove all checkpoints, also unfinished ones, but two. What could not
    /// be removed and why, or nothing. Rank 0.
    std::string
    remove_others(const std::string &keep, const std::string &keep_too) const;

    const std::string     directory;
    const ParameterValues parameters;
    const MPI_Comm        communicator;
    std::string           current;  ///< known to be sound; empty: none
    std::string           previous; ///< the one before
  };
} // namespace seiche

#endif
