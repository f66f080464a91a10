// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/displacement_pressure_vms.h>
#include <seiche/formulation/momentum_terms.h>
#include <seiche/formulation/vms_point_state.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  bool
  DisplacementPressureVMS<dim>::has_pressure() const
  {
    return true;
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::residual(CellData<dim, 1> &cell) const
  {
    add_residual(cell);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::residual(CellData<dim, 2> &cell) const
  {
    add_residual(cell);
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::add_residual(CellData<dim, degree> &cell) const
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    cell.clear_residual();
    const Tau                    tau    = this->tau(cell);
    const bool                   splits = this->stabilization.is_split();
    PointKinematics<dim, degree> point;
    for (unsigned int q = 0; q < cell.quadrature.size; ++q)
      {
        point.evaluate(cell, q, /*with_end=*/false);
        const VMSPointState<dim, degree> state(
          cell, point, q, this->material, tau, splits);
        MomentumTerms<dim, degree>::add_residual(cell,
                                                 point,
                                                 cell.quadrature.mass[q],
                                                 state.volume_t,
                                                 state.acceleration,
                                                 cell.body_force_at(q),
                                                 state.stress);

        const double coarse =
          cell.quadrature.volume[q] *
          (state.constraint +
           state.fine_pressure / this->material.bulk_modulus);
        for (unsigned int a = 0; a < n_nodes; ++a)
          cell.residual_p[a] += coarse * point.N[a];
        if (!cell.sliver)
          for (unsigned int i = 0; i < dim; ++i)
            {
              const double fine =
                state.volume_t * tau.momentum * state.momentum_residual[i];
              for (unsigned int a = 0; a < n_nodes; ++a)
                cell.residual_p[a] -= fine * point.gradient_t[i][a];
            }
      }
    if (cell.sliver && tau.momentum > 0.)
      sliver_residual(cell, tau.momentum);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::tangent(CellData<dim, 1> &cell) const
  {
    add_tangent(cell);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::tangent(CellData<dim, 2> &cell) const
  {
    add_tangent(cell);
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::add_tangent(CellData<dim, degree> &cell) const
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    cell.clear_tangent();
    const Tau    tau       = this->tau(cell);
    const double viscosity = this->material.viscosity(cell.coefficients);
    const double theta     = cell.coefficients.theta;
    const double kappa     = this->material.bulk_modulus;
    const double weight_g  = 1. - tau.continuity / kappa;
    const bool   splits    = this->stabilization.is_split();
    PointKinematics<dim, degree> point;
    for (unsigned int q = 0; q < cell.quadrature.size; ++q)
      {
        point.evaluate(cell, q, /*with_end=*/true);
        const VMSPointState<dim, degree> state(
          cell, point, q, this->material, tau, splits);
        const double       V0 = cell.quadrature.volume[q];
        alignas(64) double h[dim][n_nodes]; // d(constraint)/du
        state.constraint_slope(cell, point, h);
        MomentumTerms<dim, degree>::add_tangent(cell,
                                                point,
                                                cell.quadrature.mass[q],
                                                state.volume_t,
                                                viscosity,
                                                tau.continuity,
                                                h,
                                                state.velocity_gradient,
                                                state.stress);
        const auto &N = point.N;
        const auto &g = point.gradient_t;

        // V_t tau1 {theta [(grad q.grad p) div du + grad q.(grad du) r
        //                  - grad p.(grad du)^T grad q] + rho C_a grad q.du}
        const double fine = cell.sliver ? 0. : state.volume_t * tau.momentum;
        // grad N.(grad p + Pi r - div s) and grad N.r
        alignas(64) double gp[n_nodes], gr[n_nodes];
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            gp[a] = gr[a] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              {
                gp[a] +=
                  g[j][a] * (state.pressure_gradient[j] + state.projected[j] -
                             state.stress_divergence[j]);
                gr[a] += g[j][a] * state.momentum_residual[j];
              }
          }
        const double inertia =
          state.is_split ? 0. : fine * state.rho_t * cell.coefficients.inertia;
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const double of_N       = weight_g * V0 / kappa * N[a];
            const double divergence = weight_g * V0 * N[a];
            auto        &row_pp     = cell.pp[a];
#pragma omp simd
            for (unsigned int b = 0; b < n_nodes; ++b)
              {
                double sum = 0.;
                for (unsigned int j = 0; j < dim; ++j)
                  sum += g[j][a] * g[j][b];
                row_pp[b] += of_N * N[b] + fine * sum;
              }
            for (unsigned int k = 0; k < dim; ++k)
              {
                double of_g[dim]; // factors of g
                for (unsigned int j = 0; j < dim; ++j)
                  of_g[j] =
                    -theta * fine * state.pressure_gradient[k] * g[j][a];
                of_g[k] += theta * fine * gp[a];
                const double of_gr = theta * fine * g[k][a];
                const double of_a  = inertia * g[k][a];
                auto        &row   = cell.pu[k][a];
#pragma omp simd
                for (unsigned int b = 0; b < n_nodes; ++b)
                  {
                    double sum =
                      divergence * h[k][b] + of_gr * gr[b] + of_a * N[b];
                    for (unsigned int j = 0; j < dim; ++j)
                      sum += of_g[j] * g[j][b];
                    row[b] += sum;
                  }
              }
            for (unsigned int i = 0; i < dim; ++i)
              {
                const double force = -weight_g * state.volume_t * g[i][a];
                auto        &row   = cell.up[i][a];
#pragma omp simd
                for (unsigned int b = 0; b < n_nodes; ++b)
                  row[b] += force * N[b];
              }
          }
        if constexpr (degree > 1)
          if (viscosity != 0. && fine != 0. && !state.is_split)
            {
              double derivative[dim][dim][n_nodes];
              state.stress_divergence_derivative(cell,
                                                 point,
                                                 fine * viscosity,
                                                 derivative);
              for (unsigned int k = 0; k < dim; ++k)
                for (unsigned int i = 0; i < dim; ++i)
                  for (unsigned int a = 0; a < n_nodes; ++a)
                    for (unsigned int b = 0; b < n_nodes; ++b)
                      cell.pu[k][a][b] -= g[i][a] * derivative[i][k][b];
            }
      }
    if (cell.sliver && tau.momentum > 0.)
      sliver_tangent(cell, tau.momentum);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::projected_terms(CellData<dim, 1> &cell) const
  {
    add_projected_terms(cell);
  }

  template <int dim>
  void
  DisplacementPressureVMS<dim>::projected_terms(CellData<dim, 2> &cell) const
  {
    add_projected_terms(cell);
  }

  template <int dim>
  template <int degree>
  void
  DisplacementPressureVMS<dim>::add_projected_terms(
    CellData<dim, degree> &cell) const
  {
    cell.clear_residual();
    const Tau                    tau    = this->tau(cell);
    const bool                   splits = this->stabilization.is_split();
    const bool                   lumped = this->stabilization.projects_lumped();
    PointKinematics<dim, degree> point;
    for (unsigned int q = 0; q < cell.quadrature.size; ++q)
      {
        point.evaluate(cell, q, /*with_end=*/false);
        const VMSPointState<dim, degree> state(
          cell, point, q, this->material, tau, splits);
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          {
            const double weight = cell.quadrature.volume[q] *
                                  (lumped ? point.lumped(a) : point.N[a]);
            for (unsigned int i = 0; i < dim; ++i)
              cell.residual_u[i][a] +=
                weight * (state.momentum_residual[i] + state.projected[i]);
            cell.residual_p[a] += weight * state.constraint;
          }
      }
  }

  template class DisplacementPressureVMS<2>;
  template class DisplacementPressureVMS<3>;
} // namespace seiche
