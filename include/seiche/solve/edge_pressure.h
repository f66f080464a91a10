// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_edge_pressure_h
#define seiche_solve_edge_pressure_h

#include <seiche/algebra/cell_matrix.h>
#include <seiche/space/line_matrices.h>
#include <seiche/space/occupancy.h>

namespace seiche
{
  /**
   * @brief Pressure of walls' faces at the nodes of a cell that an oblique
   * normal n holds (doc/theory.md (8.0e)):
   *
   *     G_Ib = (I - n n^T) sum_f n_f int_f N_I N_b dA,
   *
   * n_f out of the fluid. Such a node's test function is not tangential to the
   * faces, so that the wall's pressure does not drop out; without it water at
   * rest would move round the edge. Faces count as a whole.
   */
  template <int dim, int degree>
  class EdgePressure
  {
  public:
    using Shape                           = Basis<dim, degree>;
    static constexpr unsigned int n_nodes = Shape::n_nodes;

    /// Of an own occupied cell.
    EdgePressure(const Occupancy<dim> &occupancy, const unsigned int cell)
    {
      const auto  nodes       = occupancy.template unknowns<degree>(cell);
      const auto &constraints = occupancy.constraints;
      for (const BoxFace face : dealii::GeometryInfo<dim>::face_indices())
        if (occupancy.locator.cells.closed_wall_at(cell, face) != nullptr)
          add_face(occupancy.locator.cells.geometry(cell), face);
      for (auto &component : G)
        nodes.condense_matrix(component);
      for (unsigned int a = 0; a < n_nodes; ++a)
        project(a,
                constraints.is_oblique(nodes[a]) ?
                  constraints.projector(nodes[a]) :
                  dealii::Tensor<2, dim>());
    }

    /// @p force [N] += G p; both by node of the grid.
    void
    add_force(const CellUnknowns<dim, degree> &nodes,
              const double                    *pressure,
              double                          *force) const
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            force[dim * nodes[a] + i] += G[i][a][b] * pressure[nodes[b]];
    }

    /// After the cell's own tangent.
    void
    add_tangent(CellMatrix<dim, degree> &cell) const
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            cell.up[i][a][b] += G[i][a][b];
    }

  private:
    void
    add_face(const CellGeometry<dim> &geometry, const BoxFace face)
    {
      const unsigned int d = face.direction();
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int b = 0; b < n_nodes; ++b)
          if (is_on_face<dim>(degree, a, face) &&
              is_on_face<dim>(degree, b, face))
            {
              double mass =
                face.outward() * geometry.measure / geometry.edges[d];
              for (unsigned int c = 0; c < dim; ++c)
                if (c != d)
                  mass *= line_mass[degree - 1][Shape::line_index(a, c)]
                                   [Shape::line_index(b, c)];
              G[d][a][b] += mass;
            }
    }

    void
    project(const unsigned int a, const dealii::Tensor<2, dim> &P)
    {
      for (unsigned int b = 0; b < n_nodes; ++b)
        {
          dealii::Tensor<1, dim> row;
          for (unsigned int i = 0; i < dim; ++i)
            row[i] = G[i][a][b];
          row = P * row;
          for (unsigned int i = 0; i < dim; ++i)
            G[i][a][b] = row[i];
        }
    }

    double G[dim][n_nodes][n_nodes] = {};
  };
} // namespace seiche

#endif
