// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/node_constraints.h>

#include <deal.II/lac/la_parallel_vector.h>

namespace seiche
{
  using namespace dealii;

  using Vector = LinearAlgebra::distributed::Vector<double>;

  template <int dim>
  void
  NodeConstraints<dim>::reinit(
    const std::vector<unsigned int>                          &nodes,
    const std::shared_ptr<const Utilities::MPI::Partitioner> &node_partitioner)
  {
    mesh_node   = &nodes;
    partitioner = node_partitioner;
    obliques.clear();
    at_faces.assign(partitioner->locally_owned_size(), 0);
    fixed.resize(nodes.size());
    for (unsigned int node = 0; node < fixed.size(); ++node)
      fixed[node] = wall_components(node);
    held.assign(fixed.begin(),
                fixed.begin() + partitioner->locally_owned_size());
  }

  template <int dim>
  Tensor<2, dim>
  NodeConstraints<dim>::projector(const unsigned int node) const
  {
    Tensor<2, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      if (!((fixed[node] >> c) & 1u))
        result[c][c] = 1.;
    if ((fixed[node] >> dim) & 1u)
      result -= outer_product(oblique_normal(node), oblique_normal(node));
    return result;
  }

  template <int dim>
  void
  NodeConstraints<dim>::set_free(const unsigned int node,
                                 const unsigned int components,
                                 const unsigned int components_at_faces)
  {
    at_faces[node] = components_at_faces;
    obliques.erase(node);
    held[node] = fixed[node] = wall_components(node) & ~components;
  }

  template <int dim>
  void
  NodeConstraints<dim>::set_oblique(const unsigned int    node,
                                    const unsigned int    components,
                                    const Tensor<1, dim> &normal)
  {
    obliques[node] = {components, normal};
    held[node] = fixed[node] = (held[node] & ~components) | (1u << dim);
  }

  template <int dim>
  void
  NodeConstraints<dim>::set_released(const WallDirection<dim> &direction,
                                     const bool                released)
  {
    const unsigned int bit = held[direction.node] & (1u << direction.component);
    unsigned int      &components = fixed[direction.node];
    components = released ? components & ~bit : components | bit;
  }

  template <int dim>
  void
  NodeConstraints<dim>::share()
  {
    Vector mask(partitioner);
    for (unsigned int node = 0; node < held.size(); ++node)
      mask.local_element(node) = fixed[node];
    mask.update_ghost_values();
    for (unsigned int node = held.size(); node < fixed.size(); ++node)
      fixed[node] = static_cast<unsigned int>(mask.local_element(node));
  }

  template <int dim>
  void
  NodeConstraints<dim>::share_obliques()
  {
    share();
    std::array<Vector, dim> normals;
    for (unsigned int c = 0; c < dim; ++c)
      {
        normals[c].reinit(partitioner);
        for (const auto &[node, oblique] : obliques)
          if (node < held.size())
            normals[c].local_element(node) = oblique.normal[c];
        normals[c].update_ghost_values();
      }
    for (unsigned int node = held.size(); node < fixed.size(); ++node)
      if (is_oblique(node))
        for (unsigned int c = 0; c < dim; ++c)
          obliques[node].normal[c] = normals[c].local_element(node);
      else
        obliques.erase(node);
  }

  template class NodeConstraints<2>;
  template class NodeConstraints<3>;
} // namespace seiche
