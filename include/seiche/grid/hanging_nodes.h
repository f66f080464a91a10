// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_hanging_nodes_h
#define seiche_grid_hanging_nodes_h

#include <seiche/points/cell_locator.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/lac/affine_constraints.h>

#include <map>
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
   * list: v = C v^, R^ = C^T R, K^ = C^T K C. Sums of shape functions stay
   * one, so that sums over points conserve mass and momentum. Cells without
   * hanging nodes, nearly all, have no matrix.
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
           const CellLocator<dim>        &locator);

    /// Nodes of a cell [n_nodes], masters in place of hanging nodes: full
    /// global numbering.
    const dealii::types::global_dof_index *
    nodes(const unsigned int cell) const
    {
      return cell_nodes.data() + cell * n_nodes;
    }

    /// True if some node of the cell hangs.
    bool
    has_matrix(const unsigned int cell) const
    {
      return matrix_of_cell[cell] >= 0;
    }

    /// True if node a of the cell hangs.
    bool
    hangs(const unsigned int cell, const unsigned int a) const;

    /// values <- C values [n_nodes]
    void
    expand(const unsigned int cell, double *values) const
    {
      if (has_matrix(cell))
        multiply(cell, values);
    }

    /// values <- C^T values [n_nodes]
    void
    condense(const unsigned int cell, double *values) const
    {
      if (has_matrix(cell))
        multiply_transposed(cell, values);
    }

    /// matrix <- C^T matrix C, [n][n] with n = n_nodes
    template <unsigned int n>
    void
    condense_matrix(const unsigned int cell, double (&matrix)[n][n]) const
    {
      AssertDimension(n, n_nodes);
      if (!has_matrix(cell))
        return;
      double column[n];
      for (unsigned int b = 0; b < n; ++b)
        {
          for (unsigned int a = 0; a < n; ++a)
            column[a] = matrix[a][b];
          multiply_transposed(cell, column);
          for (unsigned int a = 0; a < n; ++a)
            matrix[a][b] = column[a];
        }
      for (unsigned int a = 0; a < n; ++a)
        multiply_transposed(cell, matrix[a]);
    }

  private:
    using Constraints = dealii::AffineConstraints<double>;

    /// Nodes and matrix of an own cell.
    void
    resolve(const unsigned int                                  cell,
            const std::vector<dealii::types::global_dof_index> &dofs,
            const Constraints                                  &constraints);
    /// Of ghost cells, from their owners. Collective.
    void
    exchange(const CellLocator<dim> &locator);
    int
    store(const std::vector<double> &matrix);

    void
    multiply(const unsigned int cell, double *values) const;
    void
    multiply_transposed(const unsigned int cell, double *values) const;

    unsigned int                                 n_nodes = 0;
    std::vector<dealii::types::global_dof_index> cell_nodes;
    std::vector<int>                             matrix_of_cell; // or -1
    std::vector<std::vector<double>>             matrices; // [a * n_nodes + b]
    std::map<std::vector<double>, int>           known;
  };
} // namespace seiche

#endif
