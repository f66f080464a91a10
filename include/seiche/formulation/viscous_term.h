// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_viscous_term_h
#define seiche_formulation_viscous_term_h

#include <seiche/formulation/stress_divergence.h>
#include <seiche/formulation/term.h>

namespace seiche
{
  /// V_t s:grad_t w of the viscous stress (doc/theory.md (2.1), (4.2)); with
  /// FE_Q(2) div s in r (4.4).
  struct ViscousTerm : Term
  {
    static constexpr bool is_viscous = true;

    /// Ratio of viscous forces to inertia in a cell, mu c_r/(rho C_a h^2),
    /// below which the tangent leaves viscous terms out (doc/theory.md (10.3)).
    static constexpr double negligible = 1e-4;

    /// False where viscous terms are so small beside inertia that Newton's
    /// iteration does not miss them.
    template <int dim, int degree>
    static bool
    in_tangent(const CellData<dim, degree> &cell)
    {
      const StepCoefficients &step = cell.coefficients;
      const double            h    = cell.geometry.shortest_edge() / degree;
      return cell.fluid.is_viscous() &&
             0.5 * cell.fluid.stiffness(step.rate) >=
               negligible * cell.fluid.inertia(step.inertia) * h * h;
    }

    template <int dim, int degree>
    bool
    needs_velocity_gradient(const CellData<dim, degree> &cell) const
    {
      return cell.fluid.is_viscous();
    }

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      if (!state.cell.fluid.is_viscous())
        return;
      state.viscous.evaluate(*state.material.law, state.velocity_gradient);
      if constexpr (degree > 1)
        if (state.cell.residual_parts.force)
          add_stress_divergence(state);
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      if (state.cell.fluid.is_viscous())
        forces.stress += state.volume_t * state.viscous.stress();
    }

    /**
     * V_t ds:grad_t w + theta V_t {(div_t du) s:grad_t w - s:(grad_t w grad_t
     * du)}, ds as of ViscousStress with dl = (c_r I - theta l) grad_t du
     * (4.7a).
     */
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree>      &sums,
                CellData<dim, degree>         &cell) const
    {
      if (!in_tangent(cell))
        return;
      const auto &viscous = state.viscous;
      const auto &g       = state.point.gradient_t;
      const auto  m =
        rate_of_increment(state, viscous.mu.value * state.volume_t);
      Lanes rate[dim][state.n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < state.n_nodes; ++a)
          {
            rate[i][a] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              rate[i][a] += m[j][i] * g[j][a];
            sums.divergence[i][a] -= 2. / 3. * rate[i][a];
          }
      add_transposed(state, rate, cell);
      add_laplacian(state, m, cell);
      add_turned_stress(state, cell);
      if (viscous.has_slope)
        add_thinning(state,
                     rate_of_increment(state,
                                       2. * viscous.mu.slope * state.volume_t),
                     cell);
    }

  private:
    /// m of ds = 2 mu dev(sym(m grad_t du)), times @p factor.
    template <int dim, int degree>
    static dealii::Tensor<2, dim, Lanes>
    rate_of_increment(const PointState<dim, degree> &state, const Lanes factor)
    {
      dealii::Tensor<2, dim, Lanes> m =
        -state.cell.coefficients.theta * state.velocity_gradient;
      for (unsigned int i = 0; i < dim; ++i)
        m[i][i] += state.cell.coefficients.rate;
      return factor * m;
    }

    /// The transposed gradient's part: uu_ik[a][b] += rate_k[a] g_i[b].
    template <int dim, int degree>
    static void
    add_transposed(const PointState<dim, degree> &state,
                   const Lanes (&rate)[dim][PointState<dim, degree>::n_nodes],
                   CellData<dim, degree> &cell)
    {
      const auto g    = rows_of<dim>(state.point.gradient_t),
                 rows = rows_of<dim>(rate);
      add_products(cell,
                   state.n_points,
                   [&](const auto i, const auto k, const auto q, const auto a) {
                     return rows[k].values[q][a] * g[i].row(q);
                   });
    }

    /// The viscosity's own derivative: add (e:grad_t w) (e:(m grad_t du)).
    template <int dim, int degree>
    static void
    add_thinning(const PointState<dim, degree>       &state,
                 const dealii::Tensor<2, dim, Lanes> &m,
                 CellData<dim, degree>               &cell)
    {
      const auto &e   = state.viscous.e;
      const auto  e_m = e * m; // e is symmetric
      const auto &g   = state.point.gradient_t;
      Lanes       test[dim][state.n_nodes], trial[dim][state.n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < state.n_nodes; ++a)
          {
            test[i][a] = trial[i][a] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              {
                test[i][a] += e[i][j] * g[j][a];
                trial[i][a] += e_m[j][i] * g[j][a];
              }
          }
      const auto test_rows  = rows_of<dim>(test),
                 trial_rows = rows_of<dim>(trial);
      add_products(cell,
                   state.n_points,
                   [&](const auto i, const auto k, const auto q, const auto a) {
                     return test_rows[i].values[q][a] * trial_rows[k].row(q);
                   });
    }

    /// Add theta V_t {(div_t du) s:grad_t w - s:(grad_t w grad_t du)}.
    template <int dim, int degree>
    static void
    add_turned_stress(const PointState<dim, degree> &state,
                      CellData<dim, degree>         &cell)
    {
      const Lanes weight = cell.coefficients.theta * state.volume_t;
      const auto  stress = state.viscous.stress();
      const auto &g      = state.point.gradient_t;
      Lanes       sg[dim][state.n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < state.n_nodes; ++a)
          {
            Lanes force = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              force += stress[i][j] * g[j][a];
            sg[i][a] = weight * force;
          }
      const auto g_rows = rows_of<dim>(g), sg_rows = rows_of<dim>(sg);
      add_products(cell,
                   state.n_points,
                   [&](const auto i, const auto k, const auto q, const auto a) {
                     return sg_rows[i].values[q][a] * g_rows[k].row(q) -
                            g_rows[k].values[q][a] * sg_rows[i].row(q);
                   });
    }

    /// Add m_ik grad_t w_i.grad_t du_k.
    template <int dim, int degree>
    static void
    add_laplacian(const PointState<dim, degree>       &state,
                  const dealii::Tensor<2, dim, Lanes> &m,
                  CellData<dim, degree>               &cell)
    {
      constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
      const auto             g       = rows_of<dim>(state.point.gradient_t);
      alignas(64) double     m_q[n_lanes_of_register][dim][dim];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          {
            const LaneValues values(m[i][k]);
            for (unsigned int q = 0; q < state.n_points; ++q)
              m_q[q][i][k] = values[q];
          }
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> sums[dim][dim];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              sums[i][k] = load_row(cell.uu[i][k][a]);
          for (unsigned int q = 0; q < state.n_points; ++q)
            {
              const Row<n_nodes> product = gradient_product(g, q, a);
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int k = 0; k < dim; ++k)
                  sums[i][k] += m_q[q][i][k] * product;
            }
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              store_row(sums[i][k], cell.uu[i][k][a]);
        }
    }
  };
} // namespace seiche

#endif
