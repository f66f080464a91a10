// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_over_ranks_h
#define seiche_utilities_over_ranks_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

namespace seiche
{
  /// Replace each number of an array or vector, as long on every rank, by its
  /// sum over all ranks. Collective.
  template <typename Numbers>
  void
  sum_over_ranks(Numbers &numbers, const MPI_Comm communicator)
  {
    using Number = typename Numbers::value_type;
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const Number>(numbers.data(), numbers.size()),
      communicator,
      dealii::ArrayView<Number>(numbers.data(), numbers.size()));
  }

  /// The same with the largest instead of the sum. Collective.
  template <typename Numbers>
  void
  maximum_over_ranks(Numbers &numbers, const MPI_Comm communicator)
  {
    using Number = typename Numbers::value_type;
    dealii::Utilities::MPI::max(
      dealii::ArrayView<const Number>(numbers.data(), numbers.size()),
      communicator,
      dealii::ArrayView<Number>(numbers.data(), numbers.size()));
  }
} // namespace seiche

#endif
