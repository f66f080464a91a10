// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_inertia_term_h
#define seiche_formulation_inertia_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /// sum m a.w, or of a lumped mass sum_I (sum_p m N_I) a_I.w_I (doc/theory.md
  /// (4.2); section 4); -rho_t a in r (4.4).
  struct InertiaTerm : Term
  {
    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      if (state.cell.residual_parts.inertia)
        state.r -= state.rho_t * state.acceleration;
    }

    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &state) const
    {
      if (state.cell.residual_parts.inertia)
        state.r_inertia = state.rho_t * state.cell.coefficients.inertia;
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      if (!state.cell.lumped)
        forces.force += state.mass * state.acceleration;
    }

    template <int dim, int degree>
    void
    add_nodal_residual(const PointState<dim, degree> &state,
                       NodalSums<dim, degree>        &sums) const
    {
      if (state.cell.lumped)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int a = 0; a < sums.n_nodes; ++a)
            sums.u[i][a] += state.mass * state.point.weight(a) *
                            state.cell.acceleration[i][a];
    }

    /// m C_a du.w and the Coriolis acceleration's derivative (4.7a).
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree> &,
                CellData<dim, degree> &cell) const
    {
      constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
      const Lanes            mass    = state.mass * cell.coefficients.inertia;
      if (cell.lumped)
        {
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              const double weight = sum(mass * state.point.weight(a));
              for (unsigned int i = 0; i < dim; ++i)
                cell.uu[i][i][a][a] += weight;
              cell.for_each_coriolis_share([&](const unsigned int i,
                                               const unsigned int k,
                                               const double       share) {
                cell.uu[i][k][a][a] += share * weight;
              });
            }
          return;
        }
      const PointRows<n_nodes> N(state.point.N);
      const LaneValues         m(mass);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> row = 0.;
          for (unsigned int q = 0; q < state.n_points; ++q)
            row += m[q] * N.values[q][a] * N.row(q);
          for (unsigned int i = 0; i < dim; ++i)
            store_row(load_row(cell.uu[i][i][a]) + row, cell.uu[i][i][a]);
          cell.for_each_coriolis_share([&](const unsigned int i,
                                           const unsigned int k,
                                           const double       share) {
            store_row(load_row(cell.uu[i][k][a]) + share * row,
                      cell.uu[i][k][a]);
          });
        }
    }
  };
} // namespace seiche

#endif
