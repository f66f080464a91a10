// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_node_numbering_h
#define seiche_space_node_numbering_h

#include <seiche/space/mesh_nodes.h>
#include <seiche/space/occupied_cells.h>

#include <memory>
#include <vector>

namespace seiche
{
  /**
   * @brief The compact numbering of the nodes of active cells.
   *
   * Only these exist for vectors, matrices and solvers; the numbering lives
   * until a point comes to the edge of the halo. All fields share the nodes:
   * component c of node i of a vector field is entry dim*i + c. Local numbers:
   * own nodes first, then ghosts. Hanging nodes are no unknowns; their masters
   * may lie on cells without fluid.
   */
  template <int dim>
  class NodeNumbering
  {
  public:
    /// References must outlive the object.
    NodeNumbering(const MeshNodes<dim> &mesh, const OccupiedCells<dim> &cells);

    /// Number the nodes of the active cells. Collective.
    void
    reinit();

    /// Grows by one with each new numbering.
    unsigned int
    generation() const
    {
      return n_numberings;
    }

    /// Local numbers [n_dofs_per_cell()] of an active own or ghost cell,
    /// masters in place of hanging nodes; lexicographic.
    const unsigned int *
    of_cell(const unsigned int cell) const
    {
      return cell_nodes.data() + cell * mesh.fe.n_dofs_per_cell();
    }

    unsigned int
    n_own() const
    {
      return n_own_nodes;
    }

    /// Own and ghost nodes.
    unsigned int
    n_local() const
    {
      return mesh_node.size();
    }

    dealii::types::global_dof_index
    n_global() const
    {
      return layout->size();
    }

    /// Layout of a scalar field and of a vector field with dim components.
    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
    partitioner() const
    {
      return layout;
    }
    const std::shared_ptr<const dealii::Utilities::MPI::Partitioner> &
    vector_partitioner() const
    {
      return vector_layout;
    }

    /// Integral of the node's hat function of FE_Q(1) over the whole domain
    /// [m^dim]: zero where no vertex of a cell lies.
    double
    volume(const unsigned int node) const
    {
      return mesh.volume(mesh_node[node]);
    }

    /// Of an own node, or of a node of an own cell; on the lower side if it
    /// lies at a seam: CellLocator::image() is where a cell has it.
    const dealii::Point<dim> &
    position(const unsigned int node) const
    {
      return mesh.position(mesh_node[node]);
    }

    /// Numbers in MeshNodes, by those here.
    const std::vector<unsigned int> &
    in_mesh() const
    {
      return mesh_node;
    }

  private:
    /// Nodes of active cells, known to their owners and to those who need
    /// them. Collective.
    std::vector<char>
    find_used_nodes() const;

    /// Numbers for the nodes that are @p used. Collective.
    void
    number(const std::vector<char> &used);

    const MeshNodes<dim>                                      &mesh;
    const OccupiedCells<dim>                                  &cells;
    unsigned int                                               n_numberings = 0;
    unsigned int                                               n_own_nodes  = 0;
    std::vector<unsigned int>                                  cell_nodes;
    std::vector<unsigned int>                                  mesh_node;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> layout;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> vector_layout;
  };
} // namespace seiche

#endif
