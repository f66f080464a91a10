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
     * where -bulk g is the pressure that depends on u: tau2 and the constraint
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
      const double theta   = cell.coefficients.theta;
      const auto  &g       = point.gradient_t;
      const double inertia = mass * cell.coefficients.inertia;

      alignas(64) double Sg[dim][n_nodes]; // theta V_t (S grad N)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            double sum = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              sum += stress[i][j] * g[j][a];
            Sg[i][a] = theta * volume_t * sum;
          }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              const double from_div   = Sg[i][a];
              const double from_shear = g[k][a];
              const double from_bulk  = bulk * volume_t * g[i][a];
              double      *row        = cell.uu[i][k][a];
              for (unsigned int b = 0; b < n_nodes; ++b)
                row[b] += from_div * g[k][b] - from_shear * Sg[i][b] +
                          from_bulk * slope[k][b];
            }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const double weight = inertia * point.N[a];
            if (cell.sliver)
              cell.uu[i][i][a][a] += inertia * point.lumped(a);
            else
              for (unsigned int b = 0; b < n_nodes; ++b)
                cell.uu[i][i][a][b] += weight * point.N[b];
          }
      if (viscosity != 0.)
        add_viscous_tangent(cell,
                            point,
                            viscosity * volume_t,
                            velocity_gradient);
    }

  private:
    /// ds = 2 mu dev(sym(dl)), dl = (c_r I - theta l) grad_t du.
    static void
    add_viscous_tangent(CellData<dim, degree>              &cell,
                        const PointKinematics<dim, degree> &point,
                        const double                        weight, // mu V_t
                        const dealii::Tensor<2, dim>       &velocity_gradient)
    {
      const auto            &g = point.gradient_t;
      dealii::Tensor<2, dim> m = -cell.coefficients.theta * velocity_gradient;
      for (unsigned int i = 0; i < dim; ++i)
        m[i][i] += cell.coefficients.rate;

      alignas(64) double A[dim][n_nodes]; // m^T grad N
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            double sum = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              sum += m[j][k] * g[j][a];
            A[k][a] = weight * sum;
          }
      alignas(64) double gg[n_nodes][n_nodes];
      for (unsigned int a = 0; a < n_nodes; ++a)
        for (unsigned int b = 0; b < n_nodes; ++b)
          {
            double sum = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              sum += g[j][a] * g[j][b];
            gg[a][b] = weight * sum;
          }
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int a = 0; a < n_nodes; ++a)
            for (unsigned int b = 0; b < n_nodes; ++b)
              cell.uu[i][k][a][b] += m[i][k] * gg[a][b] + A[k][a] * g[i][b] -
                                     2. / 3. * g[i][a] * A[k][b];
    }
  };
} // namespace seiche

#endif
