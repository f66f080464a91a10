// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/gauss_gradients.h>
#include <seiche/formulation/point_inertia_term.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// int grad N_a . grad N_b over the unit cell.
    template <int dim, int degree>
    struct UnitStiffness
    {
      static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;

      double value[n_nodes][n_nodes] = {};

      UnitStiffness()
      {
        Point<dim> upper;
        for (unsigned int d = 0; d < dim; ++d)
          upper[d] = 1.;
        for_each_gauss_gradient<dim, degree>(
          {Point<dim>(), upper},
          [this](const double(&gradient)[dim][n_nodes], const double weight) {
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int a = 0; a < n_nodes; ++a)
                for (unsigned int b = 0; b < n_nodes; ++b)
                  value[a][b] += weight * gradient[d][a] * gradient[d][b];
          });
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
  PointInertiaTerm::add_cell_residual(CellData<dim, degree> &cell) const
  {
    const double inertia = factor * cell.extent_inertia;
    if (inertia == 0.)
      return;
    const auto &stiffness = UnitStiffness<dim, degree>::get().value;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int b = 0; b < cell.n_nodes; ++b)
        {
          const double force = inertia * cell.acceleration[i][b];
          for (unsigned int a = 0; a < cell.n_nodes; ++a)
            cell.residual_u[i][a] += force * stiffness[b][a];
        }
  }

  template <int dim, int degree>
  void
  PointInertiaTerm::add_cell_tangent(CellData<dim, degree> &cell) const
  {
    const double inertia =
      factor * cell.extent_inertia * cell.coefficients.inertia;
    if (inertia == 0.)
      return;
    const auto &stiffness = UnitStiffness<dim, degree>::get().value;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < cell.n_nodes; ++a)
        for (unsigned int b = 0; b < cell.n_nodes; ++b)
          cell.uu[i][i][a][b] += inertia * stiffness[a][b];
    cell.for_each_coriolis_share(
      [&](const unsigned int i, const unsigned int k, const double share) {
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          for (unsigned int b = 0; b < cell.n_nodes; ++b)
            cell.uu[i][k][a][b] += share * inertia * stiffness[a][b];
      });
  }

#define INSTANTIATE(dim, degree)                                             \
  template void PointInertiaTerm::add_cell_residual(CellData<dim, degree> &) \
    const;                                                                   \
  template void PointInertiaTerm::add_cell_tangent(CellData<dim, degree> &)  \
    const;
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
