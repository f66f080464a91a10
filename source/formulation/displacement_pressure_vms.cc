// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/displacement_pressure_vms.h>
#include <seiche/formulation/momentum_terms.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// What a step recovers of a point's volume error at most [-]: drops far
    /// off (J between 0.15 and 4 after a splash) would otherwise ask for an
    /// increment that no step size makes small, and Newton fails.
    constexpr double largest_recovery = 0.25;

    /// Fields and subscales at one quadrature point (doc/theory.md, VMS).
    template <int dim, int degree>
    struct PointState
    {
      double         volume_n, volume_t, rho_t;
      double         J_slope;       // J dphi/dJ at J_1
      double         constraint;    // g = phi(J_1) + p/kappa
      double         fine_pressure; // p~ = -tau2 g
      Tensor<1, dim> acceleration, pressure_gradient, momentum_residual;
      Tensor<2, dim> velocity_gradient, stress; // S = s - (p + p~) I
      Tensor<1, dim> stress_divergence;         // div s, zero for FE_Q(1)
      Tensor<3, dim> curvature; // v_i,jk, for FE_Q(2) with viscosity

      PointState(const CellData<dim, degree>  &cell,
                 PointKinematics<dim, degree> &point,
                 const unsigned int            q,
                 const MaterialConstants      &material,
                 const Tau                    &tau)
      {
        const auto &quadrature = cell.quadrature;
        // weights use the relaxed J, never the drifted one
        double error =
          cell.coefficients.volume_recovery * (quadrature.volume_ratio[q] - 1.);
        if (std::isinf(material.bulk_modulus)) // else J carries the pressure
          error = std::clamp(error, -largest_recovery, largest_recovery);
        const double J_n = 1. + error;
        volume_n         = J_n * quadrature.volume[q];
        volume_t         = point.det_t * volume_n;
        const double J_1 = point.det_1 * J_n;
        J_slope          = material.volume_law.slope(J_1);
        rho_t            = quadrature.mass[q] / volume_t;
        acceleration     = point.value(cell.acceleration);

        const double pressure = point.value(cell.pressure);
        pressure_gradient     = point.gradient(cell.pressure, point.gradient_t);
        constraint =
          material.volume_law.strain(J_1) + pressure / material.bulk_modulus;
        if (cell.coefficients.rate_constraint != 0.)
          {
            const Tensor<2, dim> l =
              point.gradient(cell.rate_velocity, point.gradient_t);
            constraint -= cell.coefficients.rate_constraint * trace(l * l);
          }
        fine_pressure = -tau.continuity * constraint;
        momentum_residual =
          rho_t * (cell.body_force_at(q) - acceleration) - pressure_gradient;

        if (cell.coefficients.viscous && !material.law.is_inviscid())
          {
            velocity_gradient =
              point.gradient(cell.rate_velocity, point.gradient_t);
            stress = material.law.stress(velocity_gradient);
            if constexpr (degree > 1)
              add_second_derivatives(cell,
                                     point,
                                     q,
                                     material.law.tangent_viscosity());
          }
        for (unsigned int i = 0; i < dim; ++i)
          stress[i][i] -= pressure + fine_pressure;
      }

      /// div s_i = mu (v_i,jj + v_j,ij/3)
      void
      add_second_derivatives(const CellData<dim, degree>  &cell,
                             PointKinematics<dim, degree> &point,
                             const unsigned int            q,
                             const double                  viscosity)
      {
        point.evaluate_second_derivatives(cell, q);
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            {
              const Tensor<1, dim> v =
                point.sum(cell.rate_velocity, point.second[j][k]);
              for (unsigned int i = 0; i < dim; ++i)
                curvature[i][j][k] = v[i];
            }
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            stress_divergence[i] +=
              viscosity * (curvature[i][j][j] + curvature[j][i][j] / 3.);
        momentum_residual += stress_divergence;
      }

      /// d(div s)_i for du = N_b e_k, times @p factor, into
      /// derivative[i][k][b].
      void
      stress_divergence_derivative(
        const CellData<dim, degree>        &cell,
        const PointKinematics<dim, degree> &point,
        const double                        factor,
        double (&derivative)[dim][dim][CellData<dim, degree>::n_nodes]) const
      {
        const double theta = cell.coefficients.theta;
        const double rate  = cell.coefficients.rate;
        const auto  &l     = velocity_gradient;
        const auto  &v     = curvature;
        const auto  &g     = point.gradient_t;
        const auto  &h     = point.second;
        for (unsigned int b = 0; b < CellData<dim, degree>::n_nodes; ++b)
          {
            double laplacian = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              laplacian += h[j][j][b];
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int k = 0; k < dim; ++k)
                {
                  double value =
                    rate * h[k][i][b] / 3. - theta * l[i][k] * laplacian;
                  if (i == k)
                    value += rate * laplacian;
                  for (unsigned int j = 0; j < dim; ++j)
                    value -=
                      theta * (2. * v[i][k][j] * g[j][b] +
                               (l[j][k] * h[j][i][b] + v[j][k][i] * g[j][b] +
                                v[j][j][k] * g[i][b]) /
                                 3.);
                  derivative[i][k][b] = factor * value;
                }
          }
      }
    };
  } // namespace

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
    const Tau                    tau = this->tau(cell);
    PointKinematics<dim, degree> point;
    for (unsigned int q = 0; q < cell.quadrature.size; ++q)
      {
        point.evaluate(cell, q, /*with_end=*/false);
        const PointState<dim, degree> state(
          cell, point, q, this->material, tau);
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
    PointKinematics<dim, degree> point;
    for (unsigned int q = 0; q < cell.quadrature.size; ++q)
      {
        point.evaluate(cell, q, /*with_end=*/true);
        const PointState<dim, degree> state(
          cell, point, q, this->material, tau);
        const double V0 = cell.quadrature.volume[q];
        MomentumTerms<dim, degree>::add_tangent(cell,
                                                point,
                                                cell.quadrature.mass[q],
                                                state.volume_t,
                                                viscosity,
                                                tau.continuity * state.J_slope,
                                                state.velocity_gradient,
                                                state.stress);
        const auto &N = point.N;
        const auto &g = point.gradient_t;
        const auto &h = point.gradient_1;

        // V_t tau1 {theta [(grad q.grad p) div du + grad q.(grad du) r
        //                  - grad p.(grad du)^T grad q] + rho C_a grad q.du}
        const double fine = cell.sliver ? 0. : state.volume_t * tau.momentum;
        alignas(64) double gp[n_nodes], gr[n_nodes]; // grad N.(grad p - div s),
                                                     // grad N.r
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            gp[a] = gr[a] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              {
                gp[a] += g[j][a] * (state.pressure_gradient[j] -
                                    state.stress_divergence[j]);
                gr[a] += g[j][a] * state.momentum_residual[j];
              }
          }
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            alignas(64) double gg[n_nodes];
            for (unsigned int b = 0; b < n_nodes; ++b)
              {
                gg[b] = 0.;
                for (unsigned int j = 0; j < dim; ++j)
                  gg[b] += g[j][a] * g[j][b];
              }
            const double mass_term = weight_g * V0 / kappa * N[a];
            for (unsigned int b = 0; b < n_nodes; ++b)
              cell.pp[a][b] += mass_term * N[b] + fine * gg[b];

            const double divergence = weight_g * V0 * state.J_slope * N[a];
            const double inertia =
              fine * state.rho_t * cell.coefficients.inertia;
            for (unsigned int k = 0; k < dim; ++k)
              {
                const double from_p = theta * fine * state.pressure_gradient[k];
                const double from_gp = theta * fine * gp[a];
                const double from_g  = theta * fine * g[k][a];
                const double from_a  = inertia * g[k][a];
                for (unsigned int b = 0; b < n_nodes; ++b)
                  cell.pu[k][a][b] += divergence * h[k][b] + from_gp * g[k][b] +
                                      from_g * gr[b] - from_p * gg[b] +
                                      from_a * N[b];
              }
            for (unsigned int i = 0; i < dim; ++i)
              {
                const double pressure_force =
                  -weight_g * state.volume_t * g[i][a];
                for (unsigned int b = 0; b < n_nodes; ++b)
                  cell.up[i][a][b] += pressure_force * N[b];
              }
          }
        if constexpr (degree > 1)
          if (viscosity != 0. && fine != 0.)
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

  template class DisplacementPressureVMS<2>;
  template class DisplacementPressureVMS<3>;
} // namespace seiche
