// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_result_folder_h
#define seiche_simulation_result_folder_h

#include <seiche/parameters/input_file.h>
#include <seiche/simulation/checkpoint_folder.h>
#include <seiche/simulation/earlier_results.h>
#include <seiche/simulation/run_report.h>
#include <seiche/utilities/directory_lock.h>

#include <mpi.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  /**
   * @brief The output folder of a run from its lock to the first files: what is
   * there already, and what every run writes before it computes.
   *
   * All functions are collective.
   */
  class ResultFolder
  {
  public:
    /// Nothing is touched. @p parameters: those that a checkpoint must have,
    /// too (fixed_parameters()).
    ResultFolder(const std::string     &directory,
                 const ParameterValues &parameters,
                 const MPI_Comm         communicator);

    bool
    exists() const;

    /// Make it, if need be, and lock it; what a run that was killed has moved
    /// comes back. InputError if there cannot be such a folder.
    void
    take();

    /// Room for a new run; the user hears where an earlier one's results are.
    void
    clear(RunReport &report) const;

    /// parameters.prm, methods.bib and the files of the report, which
    /// @p continues or not. FileError.
    void
    begin(const InputFile                &input,
          const dealii::ParameterHandler &prm,
          RunReport                      &report,
          const bool                      continues) const;

    const std::string    directory;
    const EarlierResults earlier;
    CheckpointFolder     checkpoints;

  private:
    const MPI_Comm communicator;
    DirectoryLock  lock;
  };
} // namespace seiche

#endif
