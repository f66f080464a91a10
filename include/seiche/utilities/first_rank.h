// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_first_rank_h
#define seiche_utilities_first_rank_h

#include <mpi.h>

#include <functional>

namespace seiche
{
  /// Call a function that touches files; if it fails on any rank, all throw the
  /// FileError of the first of them. Collective.
  void
  on_all_ranks(const MPI_Comm               communicator,
               const std::function<void()> &function);

  /// Call a function that touches files on rank 0; if it fails there, all
  /// ranks throw the same FileError. Collective.
  void
  on_first_rank(const MPI_Comm               communicator,
                const std::function<void()> &function);
} // namespace seiche

#endif
