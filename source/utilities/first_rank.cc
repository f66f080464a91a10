// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/exceptions.h>
#include <seiche/utilities/failure_text.h>
#include <seiche/utilities/first_rank.h>

#include <deal.II/base/mpi.h>

#include <exception>
#include <string>

namespace seiche
{
  void
  on_all_ranks(const MPI_Comm               communicator,
               const std::function<void()> &function)
  {
    std::string problem;
    try
      {
        function();
      }
    catch (const std::exception &error)
      {
        problem = failure_text(error);
      }
    const unsigned int n =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(communicator);
    const unsigned int first_failed =
      dealii::Utilities::MPI::min(problem.empty() ? n : rank, communicator);
    if (first_failed < n)
      throw FileError(
        dealii::Utilities::MPI::broadcast(communicator, problem, first_failed));
  }

  void
  on_first_rank(const MPI_Comm               communicator,
                const std::function<void()> &function)
  {
    on_all_ranks(communicator, [&]() {
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        function();
    });
  }
} // namespace seiche
