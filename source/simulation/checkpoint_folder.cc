// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/checkpoint_folder.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace seiche
{
  namespace
  {
    /// Names of checkpoints in a folder, with those that were being written if
    /// asked for; none if it does not exist.
    std::vector<std::string>
    checkpoints(const std::string &directory, const bool with_unfinished)
    {
      std::vector<std::string> names;
      std::error_code          error;
      for (const auto &entry :
           std::filesystem::directory_iterator(directory, error))
        {
          const std::string name  = entry.path().filename().string();
          const std::string whole = checked_file::final_name(name);
          if (result_names::is_checkpoint(whole) &&
              (with_unfinished || name == whole))
            names.push_back(name);
        }
      return names;
    }

    /// One after the other, each on a line of its own if there are several.
    std::string
    listed(const std::vector<std::string> &problems)
    {
      std::string text;
      for (const std::string &problem : problems)
        text += (problems.size() > 1 ? "\n  " : "") + problem;
      return text;
    }
  } // namespace



  CheckpointFolder::CheckpointFolder(const std::string     &output_directory,
                                     const ParameterValues &fixed,
                                     const MPI_Comm         mpi_communicator)
    : directory(output_directory)
    , parameters(fixed)
    , communicator(mpi_communicator)
  {}



  std::vector<std::string>
  CheckpointFolder::list() const
  {
    auto names = checkpoints(directory, /*with_unfinished=*/false);
    std::sort(names.begin(),
              names.end(),
              [](const std::string &a, const std::string &b) {
                return a.size() != b.size() ? a.size() > b.size() : a > b;
              });
    return names;
  }



  void
  CheckpointFolder::require_any(const std::string &hint) const
  {
    if (dealii::Utilities::MPI::broadcast(communicator, list()).empty())
      throw InputError(directory +
                       ": there is no checkpoint to restart from; start "
                       "without --restart, or name the folder of the earlier "
                       "run with --output" +
                       (hint.empty() ? "." : ": " + hint + "."));
  }



  std::unique_ptr<Checkpoint>
  CheckpointFolder::newest_usable(RunReport &report)
  {
    namespace MPI = dealii::Utilities::MPI;
    std::vector<std::string> problems;
    for (const std::string &name : MPI::broadcast(communicator, list()))
      {
        std::string problem;
        if (MPI::this_mpi_process(communicator) == 0)
          try
            {
              const Checkpoint candidate(directory + "/" + name);
              candidate.require_same_scene(parameters);
            }
          catch (const FileError &error)
            {
              problem = error.what();
            }
        problem = MPI::broadcast(communicator, problem);
        if (problem.empty())
          {
            current = name;
            if (!problems.empty())
              report.warn("an older checkpoint is used", listed(problems));
            return last();
          }
        problems.push_back(problem);
      }
    throw FileError("no checkpoint can be used: " + listed(problems) +
                    "\nSet entries that differ back (doc/restart.md names "
                    "those that may change); where a file is damaged, or "
                    "otherwise, start anew without --restart.");
  }



  void
  CheckpointFolder::clear() const
  {
    if (const std::string problem = remove_others("", ""); !problem.empty())
      throw FileError(problem); // a restart would take them for this run's
  }



  template <int dim>
  void
  CheckpointFolder::write(const unsigned int     step,
                          const PointCloud<dim> &points,
                          StateArchive          &state,
                          RunReport             &report)
  {
    const std::string name = result_names::checkpoint(step);
    Checkpoint::write(directory + "/" + name, points, state, parameters);
    if (name != current) // else a stop in the middle of the next step
      previous = current;
    current = name;
    std::string problem;
    on_first_rank(communicator,
                  [&]() { problem = remove_others(current, previous); });
    if (!problem.empty())
      report.warn("an old checkpoint stays", problem);
  }



  std::unique_ptr<Checkpoint>
  CheckpointFolder::last() const
  {
    return std::make_unique<Checkpoint>(directory + "/" + current);
  }



  std::string
  CheckpointFolder::remove_others(const std::string &keep,
                                  const std::string &keep_too) const
  {
    std::vector<std::string> problems;
    for (const std::string &name :
         checkpoints(directory, /*with_unfinished=*/true))
      if (name != keep && name != keep_too)
        {
          std::error_code error;
          std::filesystem::remove(directory + "/" + name, error);
          if (error)
            problems.push_back(directory + "/" + name +
                               ": this old checkpoint cannot be removed (" +
                               error.message() + "); remove it.");
        }
    return listed(problems);
  }



  template void
  CheckpointFolder::write(const unsigned int,
                          const PointCloud<2> &,
                          StateArchive &,
                          RunReport &);
  template void
  CheckpointFolder::write(const unsigned int,
                          const PointCloud<3> &,
                          StateArchive &,
                          RunReport &);
} // namespace seiche
