// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_cell_laplacian_h
#define seiche_space_cell_laplacian_h

#include <seiche/mesh/cell_geometry.h>
#include <seiche/space/basis.h>
#include <seiche/space/line_matrices.h>

namespace seiche
{
  /// K_ab = int grad N_a . grad N_b over a box, in closed form.
  template <int dim, int degree>
  struct CellLaplacian
  {
    using Shape                           = Basis<dim, degree>;
    static constexpr unsigned int n_nodes = Shape::n_nodes;

    double K[n_nodes][n_nodes];

    /// Of the unit cell.
    CellLaplacian()
    {
      dealii::Point<dim> upper;
      for (unsigned int d = 0; d < dim; ++d)
        upper[d] = 1.;
      reinit({dealii::Point<dim>(), upper});
    }

    /// Nothing is done if the edges are those of the last box.
    void
    reinit(const CellGeometry<dim> &box)
    {
      if (box.edges == edges)
        return;
      edges = box.edges;
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int b = 0; b < n_nodes; ++b)
          {
            K[a][b] = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              {
                double product = box.measure / (edges[d] * edges[d]);
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    const unsigned int i = Shape::line_index(a, c);
                    const unsigned int j = Shape::line_index(b, c);
                    product *=
                      (c == d ? line_stiffness : line_mass)[degree - 1][i][j];
                  }
                K[a][b] += product;
              }
          }
    }

  private:
    dealii::Tensor<1, dim> edges;
  };
} // namespace seiche

#endif
