// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_node_constraints_h
#define seiche_space_node_constraints_h

#include <seiche/space/mesh_nodes.h>

namespace seiche
{
  /**
   * @brief Which components of the nodes' displacements are fixed: by a wall,
   * unless there is no fluid at it (dry) or it has let go of the fluid
   * (released).
   *
   * Components are bits: bit c stands for component c. Nodes have the compact
   * numbers of Occupancy; masks of own nodes are changed here and there, and
   * share() makes them known.
   */
  template <int dim>
  class NodeConstraints
  {
  public:
    /// @p mesh_nodes must outlive the object.
    explicit NodeConstraints(const MeshNodes<dim> &mesh_nodes)
      : mesh(mesh_nodes)
    {}

    /// All walls hold. @p nodes: of the mesh, by compact number; it must stay
    /// until the next call.
    void
    reinit(const std::vector<unsigned int> &nodes,
           const std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
             &node_partitioner);

    unsigned int
    fixed_components(const unsigned int node) const
    {
      return fixed[node];
    }

    /// What walls fix, released, dry or not.
    unsigned int
    wall_components(const unsigned int node) const
    {
      return mesh.wall_components((*mesh_node)[node]);
    }

    /// The walls that fix components of an own node.
    const std::vector<NodeWall> &
    walls_at(const unsigned int node) const
    {
      return mesh.walls((*mesh_node)[node]);
    }

    /// Components of an own node whose walls have no fluid at them in this
    /// step: they do not fix it.
    void
    set_dry(const unsigned int node, const unsigned int components)
    {
      dry[node]   = components;
      fixed[node] = wall_components(node) & ~components;
    }
    unsigned int
    dry_components(const unsigned int node) const
    {
      return dry[node];
    }

    /// Release a component of an own node that a wall fixes, or fix it again.
    void
    set_released(const unsigned int node,
                 const unsigned int component,
                 const bool         released);

    /// True if a wall with fluid at it has let go of an own node: the fluid
    /// leaves it, and a gap opens that the level set does not see yet.
    bool
    leaves_wall(const unsigned int node) const
    {
      return (wall_components(node) & ~fixed_components(node) &
              ~dry_components(node)) != 0;
    }

    /// Fixed components of ghost nodes from their owners. Collective.
    void
    share();

    /// f(dim*node + component) for the components of own nodes that are fixed.
    template <typename Function>
    void
    for_each_fixed(const Function &f) const
    {
      for (unsigned int node = 0; node < partitioner->locally_owned_size();
           ++node)
        if (const unsigned int components = fixed_components(node))
          for (unsigned int c = 0; c < dim; ++c)
            if ((components >> c) & 1u)
              f(dim * node + c);
    }

  private:
    const MeshNodes<dim>            &mesh;
    const std::vector<unsigned int> *mesh_node = nullptr;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
    std::vector<unsigned int> fixed, dry; // own and ghost nodes
  };
} // namespace seiche

#endif
