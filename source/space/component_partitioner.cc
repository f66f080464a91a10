// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/component_partitioner.h>

namespace seiche
{
  using namespace dealii;

  std::shared_ptr<const Utilities::MPI::Partitioner>
  component_partitioner(const Utilities::MPI::Partitioner &nodes,
                        const unsigned int                 components)
  {
    const auto expand = [&](const IndexSet &set) {
      IndexSet result(components * set.size());
      for (auto interval = set.begin_intervals();
           interval != set.end_intervals();
           ++interval)
        result.add_range(components * *interval->begin(),
                         components * (interval->last() + 1));
      return result;
    };
    return std::make_shared<const Utilities::MPI::Partitioner>(
      expand(nodes.locally_owned_range()),
      expand(nodes.ghost_indices()),
      nodes.get_mpi_communicator());
  }
} // namespace seiche
