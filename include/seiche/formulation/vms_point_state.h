// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_vms_point_state_h
#define seiche_formulation_vms_point_state_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/point_kinematics.h>
#include <seiche/formulation/viscous_stress.h>

#include <algorithm>

namespace seiche
{
  /// Fields and subscales at several quadrature points; doc/theory.md (4.4).
  template <int dim, int degree>
  struct VMSPointState
  {
    const ResidualParts           parts; // of r
    Lanes                         volume_n, volume_t, rho_t;
    Lanes                         J_slope;       // dphi(J) = J_slope div_1 du
    Lanes                         constraint;    // g = phi(J) + p/kappa
    Lanes                         fine_pressure; // p~ = -tau2 (g - Pi g)
    Lanes                         pressure;      // p + p~
    dealii::Tensor<1, dim, Lanes> acceleration, pressure_gradient;
    dealii::Tensor<1, dim, Lanes> momentum_residual; // r - Pi r
    dealii::Tensor<1, dim, Lanes> projected;         // Pi r
    dealii::Tensor<2, dim, Lanes>
      velocity_gradient; // if a term has it, as the next
    dealii::Tensor<2, dim, Lanes> acceleration_gradient;
    ViscousStress<dim>            viscous;
    dealii::Tensor<2, dim, Lanes> stress;            // S = s - (p + p~) I
    dealii::Tensor<1, dim, Lanes> stress_divergence; // div s, zero for FE_Q(1)
    dealii::Tensor<3, dim, Lanes>
      curvature; // v_i,jk, for FE_Q(2) with viscosity

    VMSPointState(const CellData<dim, degree>  &cell,
                  PointKinematics<dim, degree> &point,
                  const unsigned int            q,
                  const Material               &material,
                  const VolumeLaw              &volume_law,
                  const Tau                    &tau,
                  const ResidualParts          &residual_parts)
      : parts(residual_parts)
    {
      const auto &quadrature = cell.quadrature;
      const Lanes J_n        = cell.coefficients.elastic ?
                                 load<Lanes>(&quadrature.volume_ratio[q]) :
                                 Lanes(1.);
      volume_n               = J_n * load<Lanes>(&quadrature.volume[q]);
      volume_t               = point.det_t * volume_n;
      const VolumeStrain<Lanes> strain(volume_law,
                                       cell.coefficients.elastic_time,
                                       J_n,
                                       point.det_1 * J_n);
      J_slope      = strain.slope;
      rho_t        = load<Lanes>(&quadrature.mass[q]) / volume_t;
      acceleration = point.value(cell.acceleration);

      pressure          = point.value(cell.pressure);
      pressure_gradient = point.gradient(cell.pressure, point.gradient_t);
      constraint = strain.value + pressure * (1. / volume_law.bulk_modulus);
      const StepCoefficients &step       = cell.coefficients;
      const bool              is_viscous = cell.viscosity > 0.;
      if (is_viscous || step.rate_constraint != 0. ||
          step.jerk_constraint != 0.)
        velocity_gradient =
          point.gradient(cell.rate_velocity, point.gradient_t);
      const dealii::Tensor<2, dim, Lanes> &l = velocity_gradient;
      if (step.rate_constraint != 0.)
        constraint -= step.rate_constraint * dealii::trace(l * l);
      if (step.jerk_constraint != 0.)
        {
          acceleration_gradient =
            point.gradient(cell.acceleration, point.gradient_t);
          if (cell.turns) // the constraint is one on relative motion
            acceleration_gradient -= coriolis_gradient(cell);
          constraint -=
            step.jerk_constraint *
            dealii::trace(3. * l * acceleration_gradient - 2. * l * l * l);
        }
      fine_pressure     = -tau.continuity * constraint;
      momentum_residual = -pressure_gradient;
      if (parts.force)
        {
          dealii::Tensor<1, dim, Lanes> force =
            cell.template body_force_at<Lanes>(q);
          if (parts.inertia)
            force -= acceleration;
          momentum_residual += rho_t * force;
        }

      if (is_viscous)
        {
          viscous.evaluate(*material.law, velocity_gradient);
          stress = viscous.stress();
          if constexpr (degree > 1)
            if (parts.force)
              add_second_derivatives(cell, point, q);
        }
      if (cell.orthogonal)
        {
          projected = point.value(cell.projected_momentum);
          momentum_residual -= projected;
          fine_pressure +=
            tau.continuity * point.value(cell.projected_constraint);
        }
      pressure += fine_pressure;
      for (unsigned int i = 0; i < dim; ++i)
        stress[i][i] -= pressure;
    }

    /// grad_t (coriolis v) = coriolis l.
    dealii::Tensor<2, dim, Lanes>
    coriolis_gradient(const CellData<dim, degree> &cell) const
    {
      dealii::Tensor<2, dim, Lanes> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          result[i] += cell.coriolis[i][k] * velocity_gradient[k];
      return result;
    }

    /// slope[k][b] = d(constraint)/d(u_kb) without the pressure's share:
    /// J dphi/dJ div_1 du, less the derivative of the jerk term,
    /// tr(M grad_t du), M = (3 grad a - 6 l^2)(c_r I - theta l)
    /// + 3 l (C_a I - theta grad a) up to cyclic order.
    void
    constraint_slope(const CellData<dim, degree>        &cell,
                     const PointKinematics<dim, degree> &point,
                     Lanes (&slope)[dim][CellData<dim, degree>::n_nodes]) const
    {
      constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int b = 0; b < n_nodes; ++b)
          slope[k][b] = J_slope * point.gradient_1[k][b];
      const StepCoefficients &c = cell.coefficients;
      if (c.jerk_constraint == 0.)
        return;
      const dealii::Tensor<2, dim, Lanes> &l      = velocity_gradient;
      const dealii::Tensor<2, dim, Lanes> &grad_a = acceleration_gradient;
      dealii::Tensor<2, dim, Lanes>        of_l   = -c.theta * l,
                                    of_a          = -c.theta * grad_a;
      for (unsigned int i = 0; i < dim; ++i)
        {
          of_l[i][i] += c.rate;
          of_a[i][i] += c.inertia;
        }
      const dealii::Tensor<2, dim, Lanes> M =
        c.jerk_constraint * ((3. * grad_a - 6. * l * l) * of_l + 3. * l * of_a);
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int b = 0; b < n_nodes; ++b)
            slope[k][b] -= M[j][k] * point.gradient_t[j][b];
    }

    /// div s_i = mu (v_i,jj + v_j,ij/3), mu that of the cell as in tau
    void
    add_second_derivatives(const CellData<dim, degree>  &cell,
                           PointKinematics<dim, degree> &point,
                           const unsigned int            q)
    {
      point.evaluate_second_derivatives(cell, q);
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int k = 0; k < dim; ++k)
          {
            const dealii::Tensor<1, dim, Lanes> v =
              point.sum(cell.rate_velocity, point.second[j][k]);
            for (unsigned int i = 0; i < dim; ++i)
              curvature[i][j][k] = v[i];
          }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          stress_divergence[i] +=
            cell.viscosity * (curvature[i][j][j] + curvature[j][i][j] / 3.);
      momentum_residual += stress_divergence;
    }

    /// d(div s)_i for du = N_b e_k over mu, times @p factor, into
    /// derivative[i][k][b].
    void
    stress_divergence_derivative(
      const CellData<dim, degree>        &cell,
      const PointKinematics<dim, degree> &point,
      const Lanes                         factor,
      Lanes (&derivative)[dim][dim][CellData<dim, degree>::n_nodes]) const
    {
      const double theta = cell.coefficients.theta;
      const double rate  = cell.coefficients.rate;
      const auto  &l     = velocity_gradient;
      const auto  &v     = curvature;
      const auto  &g     = point.gradient_t;
      const auto  &h     = point.second;
      for (unsigned int b = 0; b < CellData<dim, degree>::n_nodes; ++b)
        {
          Lanes laplacian = 0.;
          for (unsigned int j = 0; j < dim; ++j)
            laplacian += h[j][j][b];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              {
                Lanes value =
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
} // namespace seiche

#endif
