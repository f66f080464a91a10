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
  on_first_rank(const MPI_Comm               communicator,
                const std::function<void()> &function)
  {
    std::string problem;
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      try
        {
          function();
        }
      catch (const std::exception &error)
        {
          problem = failure_text(error);
        }
    problem = dealii::Utilities::MPI::broadcast(communicator, problem);
    if (!problem.empty())
      throw FileError(problem);
  }
} // namespace seiche
