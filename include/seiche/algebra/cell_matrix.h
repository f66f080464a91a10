// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_cell_matrix_h
#define seiche_algebra_cell_matrix_h

#include <seiche/space/cell_unknowns.h>
#include <seiche/space/node_constraints.h>

#include <cstring>

namespace seiche
{
  /// Matrix of one cell: blocks of displacement u and pressure p; of the
  /// irreducible form uu alone.
  template <int dim, int degree>
  struct CellMatrix
  {
    static constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;

    alignas(64) double uu[dim][dim][n_nodes][n_nodes];
    alignas(64) double up[dim][n_nodes][n_nodes]; ///< row component first
    alignas(64) double pu[dim][n_nodes][n_nodes]; ///< column component first
    alignas(64) double pp[n_nodes][n_nodes];

    void
    clear()
    {
      std::memset(uu, 0, sizeof(uu));
      std::memset(up, 0, sizeof(up));
      std::memset(pu, 0, sizeof(pu));
      std::memset(pp, 0, sizeof(pp));
    }

    /// From the element's own nodes to the unknowns.
    void
    condense(const CellUnknowns<dim, degree> &nodes)
    {
      nodes.for_each_zero([&](const unsigned int c, const unsigned int a) {
        for (unsigned int b = 0; b < n_nodes; ++b)
          {
            for (unsigned int j = 0; j < dim; ++j)
              uu[c][j][a][b] = uu[j][c][b][a] = 0.;
            up[c][a][b] = pu[c][b][a] = 0.;
          }
      });
      for (unsigned int i = 0; i < dim; ++i)
        {
          for (unsigned int j = 0; j < dim; ++j)
            nodes.condense_matrix(uu[i][j]);
          nodes.condense_matrix(up[i]);
          nodes.condense_matrix(pu[i]);
        }
      nodes.condense_matrix(pp);
    }

    /// Take the oblique normals n of nodes out: P_a uu_ab P_b, P_a up_ab, pu_ab
    /// P_b, P = I - n n^T (doc/theory.md (8.0d)).
    void
    project(const CellUnknowns<dim, degree> &nodes,
            const NodeConstraints<dim>      &constraints)
    {
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          if (!constraints.is_oblique(nodes[a]))
            continue;
          const auto remove_normal =
            [&n = constraints.oblique_normal(nodes[a])](const auto &component) {
              double along = 0.;
              for (unsigned int i = 0; i < dim; ++i)
                along += n[i] * component(i);
              for (unsigned int i = 0; i < dim; ++i)
                component(i) -= along * n[i];
            };
          for (unsigned int b = 0; b < n_nodes; ++b)
            {
              for (unsigned int k = 0; k < dim; ++k)
                remove_normal([&](const unsigned int i) -> double & {
                  return uu[i][k][a][b];
                });
              for (unsigned int k = 0; k < dim; ++k)
                remove_normal([&](const unsigned int i) -> double & {
                  return uu[k][i][b][a];
                });
              remove_normal(
                [&](const unsigned int i) -> double & { return up[i][a][b]; });
              remove_normal(
                [&](const unsigned int i) -> double & { return pu[i][b][a]; });
            }
        }
    }
  };
} // namespace seiche

#endif
