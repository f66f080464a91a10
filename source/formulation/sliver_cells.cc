// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/displacement_pressure_vms.h>
#include <seiche/formulation/gauss_gradients.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Means over the points of a sliver cell.
    template <int dim, int degree>
    struct SliverMeans
    {
      static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;

      double         volume = 0., mass = 0.;
      double         N[n_nodes] = {}; // mass-weighted
      Tensor<1, dim> body_force;

      SliverMeans(const CellData<dim, degree> &cell)
      {
        PointKinematics<dim, degree> point;
        for (unsigned int q = 0; q < cell.quadrature.size; ++q)
          {
            const double m = cell.quadrature.mass[q];
            point.shape(cell.quadrature.point(q), cell.extent);
            volume += cell.quadrature.volume[q];
            mass += m;
            for (unsigned int a = 0; a < n_nodes; ++a)
              N[a] += m * point.N[a];
            body_force += m * cell.body_force_at(q);
          }
        for (unsigned int a = 0; a < n_nodes; ++a)
          N[a] /= mass;
        body_force /= mass;
      }
    };
  } // namespace

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::sliver_residual(CellData<dim, degree> &cell,
                                                const double tau) const
  {
    constexpr unsigned int         n_nodes = CellData<dim, degree>::n_nodes;
    const SliverMeans<dim, degree> mean(cell);
    Tensor<1, dim>                 force = mean.body_force;
    if (this->stabilization.residual_parts(/*orthogonal=*/false).inertia)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          force[i] -= mean.N[a] * cell.acceleration[i][a];
    force *= mean.mass / mean.volume;

    for_each_gauss_gradient<dim, degree>(
      cell.extent,
      [&](const double(&gradient)[dim][n_nodes], const double weight) {
        const Tensor<1, dim> r =
          force -
          PointKinematics<dim, degree>::gradient(cell.pressure, gradient);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int a = 0; a < n_nodes; ++a)
            cell.residual_p[a] -=
              weight * mean.volume * tau * r[i] * gradient[i][a];
      });
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::sliver_tangent(CellData<dim, degree> &cell,
                                               const double           tau) const
  {
    constexpr unsigned int         n_nodes = CellData<dim, degree>::n_nodes;
    const SliverMeans<dim, degree> mean(cell);
    const double                   inertia =
      this->stabilization.residual_parts(/*orthogonal=*/false).inertia ?
                          mean.mass / mean.volume * cell.coefficients.inertia :
                          0.;
    for_each_gauss_gradient<dim, degree>(
      cell.extent,
      [&](const double(&gradient)[dim][n_nodes], const double weight) {
        const double fine = weight * mean.volume * tau;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int a = 0; a < n_nodes; ++a)
            for (unsigned int b = 0; b < n_nodes; ++b)
              {
                cell.pp[a][b] += fine * gradient[i][a] * gradient[i][b];
                cell.pu[i][a][b] += fine * gradient[i][a] * inertia * mean.N[b];
              }
      });
  }

#define INSTANTIATE(dim, degree)                               \
  template void DisplacementPressureVMS<dim>::sliver_residual( \
    CellData<dim, degree> &, const double) const;              \
  template void DisplacementPressureVMS<dim>::sliver_tangent(  \
    CellData<dim, degree> &, const double) const;
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
