// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_mesh_nodes_h
#define seiche_space_mesh_nodes_h

#include <seiche/space/basis.h>
#include <seiche/space/cut_walls.h>
#include <seiche/space/linear_cells.h>

#include <deal.II/base/partitioner.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>

#include <memory>
#include <vector>

namespace seiche
{
  /// A wall that fixes a component of a node, with the sides of the node on
  /// which cells have faces on it: bit 0 the upper, bit 1 the lower one, in
  /// the direction normal to the face; a smallest cell among them, own or
  /// ghost; whether a face there is normal to the component, as all are
  /// but those of no-slip walls.
  struct NodeWall
  {
    unsigned int wall, component, sides, cell;
    bool         is_normal;
  };

  /**
   * @brief The nodes of the whole mesh, and what the mesh alone says of them.
   *
   * Local numbers: own nodes first, then those of others that cells of this
   * rank need (masters of a ghost cell's hanging nodes may lie beyond the ghost
   * layer).
   */
  template <int dim>
  class MeshNodes
  {
  public:
    /// References must outlive the object.
    MeshNodes(const CellLocator<dim>  &locator,
              const dealii::FE_Q<dim> &element);

    /// After each change of the mesh. Collective.
    void
    reinit();

    /// After the locator's grid lines have moved. Collective.
    void
    update_places();

    /// Nodes [fe.n_dofs_per_cell()] of an own or ghost cell, masters in place
    /// of hanging nodes; lexicographic.
    const unsigned int *
    of_cell(const unsigned int cell) const
    {
      return cell_nodes.data() + cell * fe.n_dofs_per_cell();
    }

    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
    partitioner() const
    {
      return layout;
    }

    unsigned int
    size() const
    {
      return layout->locally_owned_size() + layout->n_ghost_indices();
    }

    /// Of a node of an own cell; on the lower side if it lies at a seam.
    const dealii::Point<dim> &
    position(const unsigned int node) const
    {
      return positions[node];
    }

    /// Integral of the node's hat function of FE_Q(1) over the whole domain
    /// [m^dim], outside of solids.
    double
    volume(const unsigned int node) const
    {
      return volumes[node];
    }

    /// The same with the inside of solids; there must be some.
    double
    full_volume(const unsigned int node) const
    {
      return full_volumes[node];
    }

    /// True if the wall of a solid cuts a cell at the node.
    bool
    is_at_cut_wall(const unsigned int node) const
    {
      return cut_walls.exist() && at_cut_walls[node];
    }

    /// Values [2^dim] at the vertices of an own or ghost cell of a nodal vector
    /// of this numbering whose shape functions are those of FE_Q(1).
    template <typename VectorType>
    void
    vertex_values(const unsigned int cell,
                  const VectorType  &vector,
                  double            *values) const;

    /// The walls that fix components of an own node.
    const std::vector<NodeWall> &
    walls(const unsigned int node) const
    {
      return walls_of_node[node];
    }

    /// Bit c is set if a wall fixes component c.
    unsigned int
    wall_components(const unsigned int node) const
    {
      return components_of_walls[node];
    }

    const CellLocator<dim>  &locator;
    const dealii::FE_Q<dim> &fe;
    HangingNodes<dim>        hanging;
    LinearCells<dim>         linear_cells; ///< FE_Q(2) only
    CutWalls<dim>            cut_walls;

  private:
    void
    number_cells();
    void
    find_positions();
    void
    find_walls();
    void
    find_volumes();

    dealii::DoFHandler<dim>                                    dof_handler;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> layout;
    std::vector<unsigned int>                                  cell_nodes;
    std::vector<dealii::Point<dim>>                            positions;
    std::vector<double>                                        volumes;
    std::vector<std::vector<NodeWall>>                         walls_of_node;
    std::vector<unsigned int> components_of_walls;
    std::vector<double>       full_volumes; // with solids
    std::vector<char>         at_cut_walls; // with solids
  };

  template <int dim>
  template <typename VectorType>
  void
  MeshNodes<dim>::vertex_values(const unsigned int cell,
                                const VectorType  &vector,
                                double            *values) const
  {
    double at_nodes[HangingNodes<dim>::max_nodes] = {};
    for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
      at_nodes[a] = vector.local_element(of_cell(cell)[a]);
    if (const NodeMatrix *matrix = hanging.matrix(cell))
      matrix->expand(at_nodes);
    for (unsigned int v = 0; v < (1u << dim); ++v)
      values[v] = at_nodes[vertex_node<dim>(fe.degree, v)];
  }
} // namespace seiche

#endif
