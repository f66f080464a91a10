// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_even_ranges_h
#define seiche_postprocess_even_ranges_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <vector>

namespace seiche
{
  /// Ranges of ids that hold about as many of all ranks' points each, one a
  /// rank: the first id of each but the first. Collective.
  std::vector<std::uint64_t>
  even_ranges(const std::vector<std::uint64_t> &ids,
              const MPI_Comm                    communicator);
} // namespace seiche

#endif
