// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_component_partitioner_h
#define seiche_space_component_partitioner_h

#include <deal.II/base/partitioner.h>

#include <memory>

namespace seiche
{
  /// Layout of a vector with @p components entries, n*node + component, for
  /// each node of @p nodes. Collective.
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
  component_partitioner(const dealii::Utilities::MPI::Partitioner &nodes,
                        const unsigned int                         components);
} // namespace seiche

#endif
