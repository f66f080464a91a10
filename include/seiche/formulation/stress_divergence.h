// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_stress_divergence_h
#define seiche_formulation_stress_divergence_h

#include <seiche/formulation/point_state.h>

namespace seiche
{
  /// Add div s_i = mu (v_i,jj + v_j,ij/3) to r (doc/theory.md (4.4a)), mu that
  /// of the cell as in tau. For degree 2.
  template <int dim, int degree>
  void
  add_stress_divergence(PointState<dim, degree> &state)
  {
    auto       &point = state.point;
    auto       &v     = state.curvature;
    const auto &cell  = state.cell;
    point.evaluate_second_derivatives(cell, state.q);
    for (unsigned int j = 0; j < dim; ++j)
      for (unsigned int k = 0; k < dim; ++k)
        {
          const dealii::Tensor<1, dim, Lanes> v_jk =
            point.sum(cell.rate_velocity, point.second[j][k]);
          for (unsigned int i = 0; i < dim; ++i)
            v[i][j][k] = v_jk[i];
        }
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        state.stress_divergence[i] +=
          cell.fluid.viscosity * (v[i][j][j] + v[j][i][j] / 3.);
    state.r += state.stress_divergence;
  }

  /// d(div s)_i for du = N_b e_k, times @p factor, into
  /// derivative[i][k][b] (doc/theory.md (4.7e)), after add_stress_divergence().
  template <int dim, int degree>
  void
  stress_divergence_derivative(
    const PointState<dim, degree> &state,
    const Lanes                    factor,
    Lanes (&derivative)[dim][dim][PointState<dim, degree>::n_nodes])
  {
    const Lanes  mu    = factor * state.cell.fluid.viscosity;
    const double theta = state.cell.coefficients.theta;
    const double rate  = state.cell.coefficients.rate;
    const auto  &l     = state.velocity_gradient;
    const auto  &v     = state.curvature;
    const auto  &g     = state.point.gradient_t;
    const auto  &h     = state.point.second;
    for (unsigned int b = 0; b < state.n_nodes; ++b)
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
                value -= theta * (2. * v[i][k][j] * g[j][b] +
                                  (l[j][k] * h[j][i][b] + v[j][k][i] * g[j][b] +
                                   v[j][j][k] * g[i][b]) /
                                    3.);
              derivative[i][k][b] = mu * value;
            }
      }
  }
} // namespace seiche

#endif
