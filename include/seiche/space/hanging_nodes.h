// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_hanging_nodes_h
#define seiche_space_hanging_nodes_h

#include <seiche/space/node_masters.h>
#include <seiche/space/node_matrix.h>

#include <vector>

namespace seiche
{
  /**
   * @brief The nodes of each cell with hanging nodes resolved.
   *
   * A hanging node is no unknown: its value is a sum over masters, nodes of
   * the coarser neighbour. In the list of a cell's nodes, masters take the
   * places of hanging nodes (a cell never has more of them), and a small
   * matrix C gives the values at its own nodes from those at the nodes of the
   * list: v = C v^, R^ = C^T R, K^ = C^T K C (doc/theory.md (9.1)). Sums of
   * shape functions stay one, so that sums over points conserve mass and
   * momentum. Cells without hanging nodes, nearly all, have no matrix. At a
   * seam, the list has the unknowns that stand for the cell's nodes.
   */
  template <int dim>
  class HangingNodes
  {
  public:
    static constexpr unsigned int max_nodes = dim == 2 ? 9 : 27;

    /// For own and ghost cells of @p locator; after each change of the mesh.
    /// Collective.
    void
    reinit(const dealii::DoFHandler<dim> &dof_handler,
           const CellLocator<dim>        &locator,
           const NodeMasters<dim>        &masters);

    /// Nodes of a cell [n_nodes], masters in place of hanging nodes: full
    /// global numbering.
    const dealii::types::global_dof_index *
    nodes(const unsigned int cell) const
    {
      return cell_nodes.data() + cell * n_nodes;
    }

    /// C of a cell, or null: no node of it hangs.
    const NodeMatrix *
    matrix(const unsigned int cell) const
    {
      return matrix_of_cell[cell];
    }

    /// True if node a of the cell hangs.
    bool
    hangs(const unsigned int cell, const unsigned int a) const
    {
      return matrix(cell) != nullptr && !matrix(cell)->is_free(a);
    }

  private:
    /// Nodes and matrix of an own cell.
    void
    resolve(const unsigned int                                  cell,
            const std::vector<dealii::types::global_dof_index> &dofs,
            const NodeMasters<dim>                             &masters);
    /// Of ghost cells, from their owners. Collective.
    void
    exchange(const CellLocator<dim> &locator);

    unsigned int                                 n_nodes = 0;
    std::vector<dealii::types::global_dof_index> cell_nodes;
    std::vector<const NodeMatrix *>              matrix_of_cell; // or null
    NodeMatrices                                 matrices;
  };
} // namespace seiche

#endif
