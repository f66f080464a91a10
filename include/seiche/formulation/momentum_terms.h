// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_momentum_terms_h
#define seiche_formulation_momentum_terms_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/point_kinematics.h>

namespace seiche
{
  /**
   * @brief The terms of the momentum balance that all formulations share:
   * inertia, body force, stress, their derivatives.
   */
  template <int dim, int degree>
  struct MomentumTerms
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;

    /// Add m N (a - b) + V_t S:grad_t w; @p stress is the whole S = s - p I.
    /// A sliver cell takes the acceleration at the node (lumped mass).
    static void
    add_residual(CellData<dim, degree>              &cell,
                 const PointKinematics<dim, degree> &point,
                 const double                        mass,
                 const double                        volume_t,
                 const dealii::Tensor<1, dim>       &acceleration,
                 const dealii::Tensor<1, dim>       &body_force,
                 const dealii::Tensor<2, dim>       &stress)
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            double force =
              cell.sliver ?
                mass * point.lumped(a) *
                  (cell.acceleration[i][a] - body_force[i]) :
                mass * point.N[a] * (acceleration[i] - body_force[i]);
            for (unsigned int j = 0; j < dim; ++j)
              force += volume_t * stress[i][j] * point.gradient_t[j][a];
            cell.residual_u[i][a] += force;
          }
    }

    /**
     * Add the derivative of the above with respect to u:
     * m C_a du.w + V_t ds:grad_t w
     * + theta V_t {(div_t du) S:grad_t w - S:(grad_t w grad_t du)}
     * + bulk V_t dg[du] div_t w,
     * where ds = 2 mu dev(sym((c_r I - theta l) grad_t du)) and -bulk g is the
     * pressure that depends on u: tau2 and the constraint
     * (mixed), kappa and the volume (irreducible); @p slope[k][b] is dg/du_kb.
     */
    static void
    add_tangent(CellData<dim, degree>              &cell,
                const PointKinematics<dim, degree> &point,
                const double                        mass,
                const double                        volume_t,
                const double                        viscosity,
                const double                        bulk,
                const double (&slope)[dim][n_nodes],
                const dealii::Tensor<2, dim> &velocity_gradient,
                const dealii::Tensor<2, dim> &stress)
    {
      using Nodal            = double[n_nodes];
      const double theta     = cell.coefficients.theta;
      const auto  &g         = point.gradient_t;
      const double inertia   = mass * cell.coefficients.inertia;
      const double viscous_t = viscosity * volume_t;
      // ds = 2 mu dev(sym(m grad_t du))
      dealii::Tensor<2, dim> m = -theta * velocity_gradient;
      for (unsigned int i = 0; i < dim; ++i)
        m[i][i] += cell.coefficients.rate;

      // theta V_t (S grad N), mu V_t m^T grad N, what multiplies div_t w
      alignas(64) double Sg[dim][n_nodes], mg[dim][n_nodes], h[dim][n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            double force = 0., rate = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              {
                force += stress[i][j] * g[j][a];
                rate += m[j][i] * g[j][a];
              }
            Sg[i][a] = theta * volume_t * force;
            mg[i][a] = viscous_t * rate;
            h[i][a]  = bulk * volume_t * slope[i][a] - 2. / 3. * mg[i][a];
          }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          {
            // factors of g: viscous terms and (div_t du) S
            alignas(64) double of_g[dim][n_nodes];
            for (unsigned int j = 0; j < dim; ++j)
              for (unsigned int a = 0; a < n_nodes; ++a)
                of_g[j][a] = viscous_t * m[i][k] * g[j][a] +
                             (j == k ? Sg[i][a] : 0.) +
                             (j == i ? mg[k][a] : 0.);
            for (unsigned int a = 0; a < n_nodes; ++a)
              {
                const double of_Sg = g[k][a], of_h = g[i][a];
                Nodal       &row = cell.uu[i][k][a];
#pragma omp simd
                for (unsigned int b = 0; b < n_nodes; ++b)
                  {
                    double sum = of_h * h[k][b] - of_Sg * Sg[i][b];
                    for (unsigned int j = 0; j < dim; ++j)
                      sum += of_g[j][a] * g[j][b];
                    row[b] += sum;
                  }
              }
          }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          if (cell.sliver)
            cell.uu[i][i][a][a] += inertia * point.lumped(a);
          else
            {
              const double weight = inertia * point.N[a];
              Nodal       &row    = cell.uu[i][i][a];
#pragma omp simd
              for (unsigned int b = 0; b < n_nodes; ++b)
                row[b] += weight * point.N[b];
            }
    }
  };
} // namespace seiche

#endif
