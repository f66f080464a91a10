// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/point_inertia_term.h>
#include <seiche/space/cell_laplacian.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim, int degree>
    const CellLaplacian<dim, degree> unit_laplacian;
  } // namespace

  template <int dim, int degree>
  void
  PointInertiaTerm::add_cell_residual(CellData<dim, degree> &cell) const
  {
    const double inertia = factor * cell.extent_inertia;
    if (inertia == 0.)
      return;
    const auto &stiffness = unit_laplacian<dim, degree>.K;
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
    const auto &stiffness = unit_laplacian<dim, degree>.K;
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
