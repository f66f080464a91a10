// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_momentum_subscale_term_h
#define seiche_formulation_momentum_subscale_term_h

#include <seiche/formulation/viscous_term.h>

namespace seiche
{
  /// -V_t grad_t q.u~ with the subscale u~ = tau1 (r - Pi r) of the
  /// displacement (doc/theory.md (4.3), (4.4); Codina 2000). FE_Q(1) leaves
  /// second derivatives of the velocity out of r: for mu c_r << rho C_a h^2
  /// they do not change the order.
  struct MomentumSubscaleTerm : Term
  {
    /// Ratio of the subscale's share in a point's displacement to the cell,
    /// theta tau1 |r|/h, below which the tangent leaves out that the gradients
    /// in this term turn with u (doc/theory.md (10.3)).
    static constexpr double negligible_turn = 0.005;

    /// theta tau1 [m^4/N] over the length that is negligible [m].
    template <int dim, int degree>
    static double
    turn_by_force(const CellData<dim, degree> &cell)
    {
      return cell.coefficients.theta * cell.tau.momentum * degree /
             (negligible_turn * cell.geometry.shortest_edge());
    }

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      if (!state.cell.orthogonal)
        return;
      state.projected = state.point.value(state.cell.projected_momentum);
      state.r -= state.projected;
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      forces.flux -= state.volume_t * state.cell.tau.momentum * state.r;
    }

    /// (4.7c) to (4.7e)
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree>      &sums,
                CellData<dim, degree>         &cell) const
    {
      const Lanes fine    = state.volume_t * cell.tau.momentum;
      const Lanes inertia = fine * state.r_inertia;
      sums.inertia += inertia;
      sums.diffusion += fine;
      if (cell.turns && cell.residual_parts.inertia)
        add_coriolis(state, inertia, cell);
      const auto f = resisting_force(state);
      if (!turns_little(state, f))
        add_turns(state, cell.coefficients.theta * fine, f, cell);
      if constexpr (degree > 1)
        if (cell.residual_parts.force && ViscousTerm::in_tangent(cell))
          add_stress_divergence_derivative(state, fine, cell);
    }

  private:
    template <int dim>
    using Vector = dealii::Tensor<1, dim, Lanes>;

    /// grad p + Pi r - div s [N/m^dim]
    template <int dim, int degree>
    static Vector<dim>
    resisting_force(const PointState<dim, degree> &state)
    {
      return state.pressure_gradient + state.projected -
             state.stress_divergence;
    }

    /// True if none of the forces that add_turns() multiplies turns the
    /// subscale at any of the points so that it counts.
    template <int dim, int degree>
    static bool
    turns_little(const PointState<dim, degree> &state, const Vector<dim> &f)
    {
      const Lanes  p    = state.pressure_gradient * state.pressure_gradient;
      const Lanes  r    = state.r * state.r;
      const double turn = turn_by_force(state.cell);
      return !std::experimental::any_of(max(max(p, r), f * f) * (turn * turn) >
                                        1.);
    }

    /// The Coriolis acceleration: pu += grad q.(coriolis_over_inertia du)
    /// inertia.
    template <int dim, int degree>
    static void
    add_coriolis(const PointState<dim, degree> &state,
                 const Lanes                    inertia,
                 CellData<dim, degree>         &cell)
    {
      constexpr unsigned int       n_nodes = CellData<dim, degree>::n_nodes;
      const dealii::Tensor<2, dim> shares  = cell.coriolis_over_inertia();
      Lanes                        inertia_N[n_nodes];
      for (unsigned int a = 0; a < n_nodes; ++a)
        inertia_N[a] = inertia * state.point.N[a];
      const PointRows<n_nodes> inertia_rows(inertia_N);
      for (unsigned int k = 0; k < dim; ++k)
        {
          Lanes turned[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              turned[a] = 0.;
              for (unsigned int i = 0; i < dim; ++i)
                turned[a] += shares[i][k] * state.point.gradient_t[i][a];
            }
          const PointRows<n_nodes> turned_rows(turned);
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              Row<n_nodes> pu = load_row(cell.pu[k][a]);
              for (unsigned int q = 0; q < state.n_points; ++q)
                pu += turned_rows.values[q][a] * inertia_rows.row(q);
              store_row(pu, cell.pu[k][a]);
            }
        }
    }

    /// The gradients of this term, V_t tau1 grad q.r, and of p in r turn with
    /// the fluid: pu += weight {(grad q.f) div du + grad q.(grad du) r -
    /// p'.(grad du)^T grad q}, p' = grad p, f = resisting_force(); @p weight
    /// theta V_t tau1 [m^(dim+2)/Pa].
    template <int dim, int degree>
    static void
    add_turns(const PointState<dim, degree> &state,
              const Lanes                    weight,
              const Vector<dim>             &f,
              CellData<dim, degree>         &cell)
    {
      constexpr unsigned int n_nodes  = CellData<dim, degree>::n_nodes;
      const auto            &gradient = state.point.gradient_t;
      Lanes                  of_f[n_nodes], of_r[n_nodes]; // times grad N
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          of_f[a] = of_r[a] = 0.;
          for (unsigned int j = 0; j < dim; ++j)
            {
              of_f[a] += weight * f[j] * gradient[j][a];
              of_r[a] += weight * state.r[j] * gradient[j][a];
            }
        }
      const PointRows<n_nodes> f_rows(of_f), r_rows(of_r);
      const auto               g = rows_of<dim>(gradient);
      alignas(64) double       p[dim][n_lanes_of_register];
      for (unsigned int k = 0; k < dim; ++k)
        (weight * state.pressure_gradient[k])
          .copy_to(p[k], std::experimental::element_aligned);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> pu[dim];
          for (unsigned int k = 0; k < dim; ++k)
            pu[k] = load_row(cell.pu[k][a]);
          for (unsigned int q = 0; q < state.n_points; ++q)
            {
              const Row<n_nodes> product = gradient_product(g, q, a);
              for (unsigned int k = 0; k < dim; ++k)
                {
                  pu[k] += f_rows.values[q][a] * g[k].row(q);
                  pu[k] += g[k].values[q][a] * r_rows.row(q);
                  pu[k] -= p[k][q] * product;
                }
            }
          for (unsigned int k = 0; k < dim; ++k)
            store_row(pu[k], cell.pu[k][a]);
        }
    }

    /// pu -= fine grad_t q.d(div s)
    template <int dim, int degree>
    static void
    add_stress_divergence_derivative(const PointState<dim, degree> &state,
                                     const Lanes                    fine,
                                     CellData<dim, degree>         &cell)
    {
      constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
      Lanes                  derivative[dim][dim][n_nodes];
      stress_divergence_derivative(state, fine, derivative);
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int a = 0; a < n_nodes; ++a)
            for (unsigned int b = 0; b < n_nodes; ++b)
              cell.pu[k][a][b] -=
                sum(state.point.gradient_t[i][a] * derivative[i][k][b]);
    }
  };
} // namespace seiche

#endif
