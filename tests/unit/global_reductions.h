// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_tests_unit_global_reductions_h
#define seiche_tests_unit_global_reductions_h

#include <deal.II/base/mpi.h>

// Sums and maxima over all ranks, for tests that run on several.
namespace
{
  const MPI_Comm communicator = MPI_COMM_WORLD;

  template <typename T>
  T
  global_sum(const T value)
  {
    return dealii::Utilities::MPI::sum(value, communicator);
  }

  inline double
  global_max(const double value)
  {
    return dealii::Utilities::MPI::max(value, communicator);
  }
} // namespace

#endif
