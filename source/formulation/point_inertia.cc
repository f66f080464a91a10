// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/point_inertia.h>

#include <deal.II/base/quadrature_lib.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// int grad N_a . grad N_b over the unit cell.
    template <int dim, int degree>
    struct UnitStiffness
    {
      using Shape                           = TensorShape<dim, degree>;
      static constexpr unsigned int n_nodes = Shape::n_nodes;

      double value[n_nodes][n_nodes] = {};

      UnitStiffness()
      {
        const QGauss<dim> gauss(degree + 1);
        double            N[n_nodes], slope[n_nodes][dim];
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            Shape::evaluate(gauss.point(q), N, slope);
            for (unsigned int a = 0; a < n_nodes; ++a)
              for (unsigned int b = 0; b < n_nodes; ++b)
                for (unsigned int d = 0; d < dim; ++d)
                  value[a][b] += gauss.weight(q) * slope[a][d] * slope[b][d];
          }
      }

      static const UnitStiffness &
      get()
      {
        static const UnitStiffness matrix;
        return matrix;
      }
    };
  } // namespace

  template <int dim, int degree>
  void
  PointInertia<dim, degree>::add_residual(CellData<dim, degree> &cell)
  {
    if (cell.extent_inertia == 0.)
      return;
    const auto &stiffness = UnitStiffness<dim, degree>::get().value;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int b = 0; b < cell.n_nodes; ++b)
        {
          const double factor = cell.extent_inertia * cell.acceleration[i][b];
          for (unsigned int a = 0; a < cell.n_nodes; ++a)
            cell.residual_u[i][a] += factor * stiffness[b][a];
        }
  }

  template <int dim, int degree>
  void
  PointInertia<dim, degree>::add_tangent(CellData<dim, degree> &cell)
  {
    if (cell.extent_inertia == 0.)
      return;
    const auto  &stiffness = UnitStiffness<dim, degree>::get().value;
    const double factor    = cell.extent_inertia * cell.coefficients.inertia;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < cell.n_nodes; ++a)
        for (unsigned int b = 0; b < cell.n_nodes; ++b)
          cell.uu[i][i][a][b] += factor * stiffness[a][b];
  }

  template struct PointInertia<2, 1>;
  template struct PointInertia<2, 2>;
  template struct PointInertia<3, 1>;
  template struct PointInertia<3, 2>;
} // namespace seiche
