// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/injected_fault.h>

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <sstream>
#include <string>

namespace seiche
{
  namespace
  {
    // in the order of Fault
    constexpr const char *names[] = {"residual",
                                     "update",
                                     "stall",
                                     "singular",
                                     "position",
                                     "velocity",
                                     "speed"};

    /// What SEICHE_FAULT asks for.
    struct Request
    {
      std::string   kind;
      unsigned long first = 0, count = 1, calls = 0;
      bool          is_of_this_rank = true;

      Request()
      {
        const char *text = std::getenv("SEICHE_FAULT");
        if (text == nullptr)
          return;
        std::istringstream stream(text);
        stream >> kind >> first;
        if (unsigned long number; stream >> number)
          count = number;
        if (unsigned int rank; stream >> rank)
          is_of_this_rank =
            rank == dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      }
    };
  } // namespace

  bool
  is_injected(const Fault fault)
  {
    static Request request;
    if (request.kind.empty() ||
        request.kind != names[static_cast<unsigned int>(fault)])
      return false;
    ++request.calls;
    return request.is_of_this_rank && request.calls >= request.first &&
           request.calls < request.first + request.count;
  }
} // namespace seiche
