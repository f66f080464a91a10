// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_node_constraints_h
#define seiche_space_node_constraints_h

#include <seiche/space/mesh_nodes.h>

#include <unordered_map>

namespace seiche
{
  /// A direction in which walls hold a node: a coordinate's, or an oblique one.
  template <int dim>
  class WallDirection
  {
  public:
    /// @p oblique: unit vector, which must outlive the object; null: the
    /// direction is that of a coordinate.
    WallDirection(const unsigned int            held_node,
                  const unsigned int            held_component,
                  const dealii::Tensor<1, dim> *oblique)
      : node(held_node)
      , component(held_component)
      , normal(oblique)
    {}

    /// sum_c n_c value(c); only coordinates that count are asked for.
    template <typename Value>
    double
    project(const Value &value) const
    {
      if (normal == nullptr)
        return value(component);
      double sum = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        if ((*normal)[c] != 0.)
          sum += (*normal)[c] * value(c);
      return sum;
    }

    /// n.v of a field of vectors, values dim*node + component.
    template <typename Vector>
    double
    of(const Vector &v) const
    {
      return project(
        [&](const unsigned int c) { return v.local_element(dim * node + c); });
    }

    /// Make n.v what is given; the rest of v stays.
    template <typename Vector>
    void
    set(Vector &v, const double value) const
    {
      if (normal == nullptr)
        v.local_element(dim * node + component) = value;
      else
        {
          const double change = value - of(v);
          for (unsigned int c = 0; c < dim; ++c)
            v.local_element(dim * node + c) += change * (*normal)[c];
        }
    }

    dealii::Tensor<1, dim>
    unit_vector() const
    {
      dealii::Tensor<1, dim> n;
      if (normal == nullptr)
        n[component] = 1.;
      else
        n = *normal;
      return n;
    }

    const unsigned int node, component;

  private:
    const dealii::Tensor<1, dim> *normal;
  };

  /**
   * @brief In which directions walls fix the nodes' displacements: not where
   * there is no fluid at them (dry), or they have let go of it (released).
   *
   * Components are bits: bit c stands for coordinate c, bit dim for an oblique
   * normal, which takes the place of components that walls fix (doc/theory.md
   * (8.0d)). What is zero in single cells alone: ZeroComponents. Nodes have the
   * compact numbers of NodeNumbering; own nodes are changed here and there, and
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

    /// All walls hold, each in its direction. @p nodes: of the mesh, by compact
    /// number; it must stay until the next call.
    void
    reinit(const std::vector<unsigned int> &nodes,
           const std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
             &node_partitioner);

    unsigned int
    fixed_components(const unsigned int node) const
    {
      return fixed[node];
    }

    bool
    is_oblique(const unsigned int node) const
    {
      return (fixed[node] >> dim) & 1u;
    }

    /// fixed_components() of all of a cell's @p nodes.
    template <typename CellNodes>
    unsigned int
    any_fixed(const CellNodes &nodes) const
    {
      unsigned int components = 0;
      for (unsigned int a = 0; a < nodes.n_nodes; ++a)
        components |= fixed[nodes[a]];
      return components;
    }

    /// True if one of a cell's @p nodes is fixed along an oblique normal.
    template <typename CellNodes>
    bool
    any_oblique(const CellNodes &nodes) const
    {
      return (any_fixed(nodes) >> dim) & 1u;
    }

    /// The oblique normal of a node with bit dim: a unit vector into the fluid.
    const dealii::Tensor<1, dim> &
    oblique_normal(const unsigned int node) const
    {
      return obliques.at(node).normal;
    }

    /// I - sum n n^T over the directions in which a node is fixed.
    dealii::Tensor<2, dim>
    projector(const unsigned int node) const;

    /// What walls fix, released, dry or not; coordinates.
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

    /// Components of an own node that walls do not fix in this step: those
    /// whose walls have no fluid at them, and @p at_faces, which are zero in the
    /// cells at their faces alone.
    void
    set_free(const unsigned int node,
             const unsigned int components,
             const unsigned int at_faces);

    /// True if a wall holds an own node in a component, as far as it is in the
    /// cells at its faces.
    bool
    is_held_at_faces(const unsigned int node,
                     const unsigned int component) const
    {
      return (at_faces[node] >> component) & 1u;
    }

    /// Fix an own node along a unit vector into the fluid instead of in the
    /// @p components that walls fix.
    void
    set_oblique(const unsigned int            node,
                const unsigned int            components,
                const dealii::Tensor<1, dim> &normal);

    /// f(direction, components) for the directions in which walls with fluid
    /// at them hold an own node, released or not; the walls of these
    /// components (coordinates) make them.
    template <typename Function>
    void
    for_each_held(const unsigned int node, const Function &f) const
    {
      for (unsigned int c = 0; c <= dim; ++c)
        if ((held[node] >> c) & 1u)
          f(direction(node, c),
            c == dim ? obliques.at(node).components : 1u << c);
    }

    bool
    is_fixed(const WallDirection<dim> &direction) const
    {
      return (fixed[direction.node] >> direction.component) & 1u;
    }

    /// Release an own node in a direction in which walls hold it, or fix it
    /// again.
    void
    set_released(const WallDirection<dim> &direction, const bool released);

    /// True if a wall with fluid at it has let go of an own node: the fluid
    /// leaves it, and a gap opens that the level set does not see yet.
    bool
    leaves_wall(const unsigned int node) const
    {
      return fixed[node] != held[node];
    }

    /// Fixed components of ghost nodes from their owners. Collective.
    void
    share();

    /// The same as share(), and oblique normals. Collective.
    void
    share_obliques();

    /// f(direction) for all directions in which own nodes are fixed.
    template <typename Function>
    void
    for_each_fixed(const Function &f) const
    {
      for (unsigned int node = 0; node < partitioner->locally_owned_size();
           ++node)
        if (const unsigned int components = fixed[node])
          for (unsigned int c = 0; c <= dim; ++c)
            if ((components >> c) & 1u)
              f(direction(node, c));
    }

  private:
    struct Oblique
    {
      unsigned int           components; ///< that it takes the place of
      dealii::Tensor<1, dim> normal;
    };

    WallDirection<dim>
    direction(const unsigned int node, const unsigned int component) const
    {
      return {node,
              component,
              component == dim ? &obliques.at(node).normal : nullptr};
    }

    const MeshNodes<dim>            &mesh;
    const std::vector<unsigned int> *mesh_node = nullptr;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
    std::vector<unsigned int>                 held;     ///< own nodes
    std::vector<unsigned int>                 fixed;    ///< own and ghost nodes
    std::unordered_map<unsigned int, Oblique> obliques; ///< by node
    std::vector<unsigned int>                 at_faces; ///< own nodes
  };
} // namespace seiche

#endif
