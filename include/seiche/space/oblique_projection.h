// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_oblique_projection_h
#define seiche_space_oblique_projection_h

#include <seiche/space/cell_unknowns.h>
#include <seiche/space/node_constraints.h>

namespace seiche
{
  /// True if one of a cell's @p nodes is fixed along an oblique normal.
  template <int dim, int degree>
  bool
  any_oblique(const NodeConstraints<dim>      &constraints,
              const CellUnknowns<dim, degree> &nodes)
  {
    unsigned int components = 0;
    for (unsigned int a = 0; a < nodes.n_nodes; ++a)
      components |= constraints.fixed_components(nodes[a]);
    return (components >> dim) & 1u;
  }

  /**
   * Take the oblique normals n of a cell's @p nodes out of its matrix: P_a uu_ab
   * P_b, P_a up_ab, pu_ab P_b with P = I - n n^T (doc/theory.md (8.0d)).
   */
  template <int dim, int degree>
  void
  project_obliques(
    const NodeConstraints<dim>      &constraints,
    const CellUnknowns<dim, degree> &nodes,
    double (
      &uu)[dim][dim][Basis<dim, degree>::n_nodes][Basis<dim, degree>::n_nodes],
    double (&up)[dim][Basis<dim, degree>::n_nodes][Basis<dim, degree>::n_nodes],
    double (&pu)[dim][Basis<dim, degree>::n_nodes][Basis<dim, degree>::n_nodes])
  {
    // takes n (n.v) from v_i = value(i)
    const auto remove = [](const dealii::Tensor<1, dim> &n, const auto &value) {
      double along = 0.;
      for (unsigned int i = 0; i < dim; ++i)
        along += n[i] * value(i);
      for (unsigned int i = 0; i < dim; ++i)
        value(i) -= along * n[i];
    };
    for (unsigned int a = 0; a < nodes.n_nodes; ++a)
      {
        if (!((constraints.fixed_components(nodes[a]) >> dim) & 1u))
          continue;
        const dealii::Tensor<1, dim> &n = constraints.oblique_normal(nodes[a]);
        for (unsigned int b = 0; b < nodes.n_nodes; ++b)
          {
            for (unsigned int k = 0; k < dim; ++k)
              remove(n, [&](const unsigned int i) -> double & {
                return uu[i][k][a][b];
              });
            for (unsigned int k = 0; k < dim; ++k)
              remove(n, [&](const unsigned int i) -> double & {
                return uu[k][i][b][a];
              });
            remove(n, [&](const unsigned int i) -> double & {
              return up[i][a][b];
            });
            remove(n, [&](const unsigned int i) -> double & {
              return pu[i][b][a];
            });
          }
      }
  }
} // namespace seiche

#endif
