// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/node_constraints.h>

#include <deal.II/lac/la_parallel_vector.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  NodeConstraints<dim>::reinit(
    const std::vector<unsigned int>                          &nodes,
    const std::shared_ptr<const Utilities::MPI::Partitioner> &node_partitioner)
  {
    mesh_node   = &nodes;
    partitioner = node_partitioner;
    dry.assign(nodes.size(), 0);
    fixed.resize(nodes.size());
    for (unsigned int node = 0; node < fixed.size(); ++node)
      fixed[node] = wall_components(node);
  }

  template <int dim>
  void
  NodeConstraints<dim>::set_released(const unsigned int node,
                                     const unsigned int component,
                                     const bool         released)
  {
    const unsigned int bit =
      wall_components(node) & ~dry[node] & (1u << component);
    fixed[node] = released ? fixed[node] & ~bit : fixed[node] | bit;
  }

  template <int dim>
  void
  NodeConstraints<dim>::share()
  {
    LinearAlgebra::distributed::Vector<double> mask(partitioner);
    const unsigned int n_own = partitioner->locally_owned_size();
    for (unsigned int node = 0; node < n_own; ++node)
      mask.local_element(node) = fixed[node];
    mask.update_ghost_values();
    for (unsigned int node = n_own; node < fixed.size(); ++node)
      fixed[node] = static_cast<unsigned int>(mask.local_element(node));
  }

  template class NodeConstraints<2>;
  template class NodeConstraints<3>;
} // namespace seiche
