// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_momentum_terms_h
#define seiche_formulation_momentum_terms_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/point_kinematics.h>
#include <seiche/formulation/viscous_stress.h>

namespace seiche
{
  /**
   * @brief The terms of the momentum balance that all formulations share:
   * inertia, body force, stress, their derivatives; at several points at once
   * (doc/theory.md (4.1), (4.2), (4.7a)).
   */
  template <int dim, int degree>
  struct MomentumTerms
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    using Kinematics                      = PointKinematics<dim, degree>;
    using Vector                          = dealii::Tensor<1, dim, Lanes>;
    using Matrix                          = dealii::Tensor<2, dim, Lanes>;

    /// Add m N (a - b) + V_t S:grad_t w; @p stress is the whole S = s - p I.
    /// A lumped mass takes the acceleration at the node.
    static void
    add_residual(const CellData<dim, degree> &cell,
                 const Kinematics            &point,
                 const Lanes                  mass,
                 const Lanes                  volume_t,
                 const Vector                &acceleration,
                 const Vector                &body_force,
                 const Matrix                &stress,
                 Lanes (&residual)[dim][n_nodes])
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Lanes force =
              cell.lumped ?
                mass * point.weight(a) *
                  (cell.acceleration[i][a] - body_force[i]) :
                mass * point.N[a] * (acceleration[i] - body_force[i]);
            for (unsigned int j = 0; j < dim; ++j)
              force += volume_t * stress[i][j] * point.gradient_t[j][a];
            residual[i][a] += force;
          }
    }

    /**
     * Add the derivative of the above with respect to u:
     * m C_a du.w (and the Coriolis acceleration's) + V_t ds:grad_t w
     * + theta V_t {(div_t du) S:grad_t w - S:(grad_t w grad_t du)}
     * + bulk V_t dg[du] div_t w,
     * where S = s - pressure I, ds as of ViscousStress with dl = (c_r I -
     * theta l) grad_t du (doc/theory.md (4.6), (4.7)), and -bulk g is the
     * pressure that depends on u: tau2 and the constraint (mixed), kappa and
     * the volume (irreducible); @p slope[k][b] is dg/du_kb. s counts if
     * @p is_viscous. The first @p n_points of the lanes count.
     */
    static void
    add_tangent(CellData<dim, degree>    &cell,
                const Kinematics         &point,
                const unsigned int        n_points,
                const Lanes               mass,
                const Lanes               volume_t,
                const bool                is_viscous,
                const ViscousStress<dim> &viscous,
                const Lanes               bulk,
                const Lanes (&slope)[dim][n_nodes],
                const Matrix &velocity_gradient,
                const Matrix &stress,
                const Lanes   pressure)
    {
      add_inertia(cell, point, n_points, mass * cell.coefficients.inertia);
      const double theta = cell.coefficients.theta;
      const auto  &g     = point.gradient_t;
      Lanes        h[dim][n_nodes]; // what multiplies div_t w
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          h[i][a] = bulk * volume_t * slope[i][a];
      if (is_viscous)
        {
          const Matrix m =
            rate_of_increment(cell,
                              velocity_gradient,
                              viscous.viscosity.value * volume_t);
          Lanes rate[dim][n_nodes];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int a = 0; a < n_nodes; ++a)
              {
                rate[i][a] = 0.;
                for (unsigned int j = 0; j < dim; ++j)
                  rate[i][a] += m[j][i] * g[j][a];
                h[i][a] -= 2. / 3. * rate[i][a];
              }
          add_transposed(cell, point, n_points, rate);
          add_laplacian(cell, point, n_points, m);
          add_turned_stress(
            cell, point, n_points, theta * volume_t, stress, pressure);
          if (viscous.has_slope)
            add_thinning(cell,
                         point,
                         n_points,
                         viscous.e,
                         rate_of_increment(cell,
                                           velocity_gradient,
                                           2. * viscous.viscosity.slope *
                                             volume_t));
        }
      add_volume_terms(cell, point, n_points, h, theta * volume_t * pressure);
    }

  private:
    /// m of ds = 2 mu dev(sym(m grad_t du)), times @p factor.
    static Matrix
    rate_of_increment(const CellData<dim, degree> &cell,
                      const Matrix                &velocity_gradient,
                      const Lanes                  factor)
    {
      Matrix m = -cell.coefficients.theta * velocity_gradient;
      for (unsigned int i = 0; i < dim; ++i)
        m[i][i] += cell.coefficients.rate;
      return factor * m;
    }

    /// Add div_t w h.du + turn {w_i,k du_k,i - (div_t w) (div_t du)}: the
    /// latter is antisymmetric in i and k.
    static void
    add_volume_terms(CellData<dim, degree> &cell,
                     const Kinematics      &point,
                     const unsigned int     n_points,
                     const Lanes (&h)[dim][n_nodes],
                     const Lanes turn)
    {
      Lanes turned[dim][n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          turned[i][a] = turn * point.gradient_t[i][a];
      const auto g = rows_of<dim>(point.gradient_t), h_rows = rows_of<dim>(h),
                 turned_rows = rows_of<dim>(turned);
      for (unsigned int i = 0; i < dim; ++i)
        {
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              Row<n_nodes> sum = load_row(cell.uu[i][i][a]);
              for (unsigned int q = 0; q < n_points; ++q)
                sum += g[i].values[q][a] * h_rows[i].row(q);
              store_row(sum, cell.uu[i][i][a]);
            }
          for (unsigned int k = i + 1; k < dim; ++k)
            {
              Row<n_nodes> ik[n_nodes], ki[n_nodes], turns[n_nodes];
              for (unsigned int a = 0; a < n_nodes; ++a)
                {
                  ik[a]    = load_row(cell.uu[i][k][a]);
                  ki[a]    = load_row(cell.uu[k][i][a]);
                  turns[a] = 0.;
                }
              for (unsigned int q = 0; q < n_points; ++q)
                for (unsigned int a = 0; a < n_nodes; ++a)
                  {
                    ik[a] += g[i].values[q][a] * h_rows[k].row(q);
                    ki[a] += g[k].values[q][a] * h_rows[i].row(q);
                    turns[a] += turned_rows[k].values[q][a] * g[i].row(q);
                    turns[a] -= turned_rows[i].values[q][a] * g[k].row(q);
                  }
              for (unsigned int a = 0; a < n_nodes; ++a)
                {
                  store_row(ik[a] + turns[a], cell.uu[i][k][a]);
                  store_row(ki[a] - turns[a], cell.uu[k][i][a]);
                }
            }
        }
    }

    /// uu_ik[a][b] += term(i, k, q, a)[b], of all points.
    template <typename Term>
    static void
    add_products(CellData<dim, degree> &cell,
                 const unsigned int     n_points,
                 const Term            &term)
    {
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          {
            Row<n_nodes> sums[n_nodes];
            for (unsigned int a = 0; a < n_nodes; ++a)
              sums[a] = load_row(cell.uu[i][k][a]);
            for (unsigned int q = 0; q < n_points; ++q)
              for (unsigned int a = 0; a < n_nodes; ++a)
                sums[a] += term(i, k, q, a);
            for (unsigned int a = 0; a < n_nodes; ++a)
              store_row(sums[a], cell.uu[i][k][a]);
          }
    }

    /// The transposed gradient's part of the viscous stress: uu_ik[a][b] +=
    /// rate_k[a] g_i[b].
    static void
    add_transposed(CellData<dim, degree> &cell,
                   const Kinematics      &point,
                   const unsigned int     n_points,
                   const Lanes (&rate)[dim][n_nodes])
    {
      const auto g = rows_of<dim>(point.gradient_t), rows = rows_of<dim>(rate);
      add_products(cell,
                   n_points,
                   [&](const unsigned int i,
                       const unsigned int k,
                       const unsigned int q,
                       const unsigned int a) -> Row<n_nodes> {
                     return rows[k].values[q][a] * g[i].row(q);
                   });
    }

    /// The viscosity's own derivative: add (e:grad_t w) (e:(m grad_t du)).
    static void
    add_thinning(CellData<dim, degree> &cell,
                 const Kinematics      &point,
                 const unsigned int     n_points,
                 const Matrix          &e,
                 const Matrix          &m)
    {
      const Matrix e_m = e * m; // e is symmetric
      Lanes        test[dim][n_nodes], trial[dim][n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            test[i][a] = trial[i][a] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              {
                test[i][a] += e[i][j] * point.gradient_t[j][a];
                trial[i][a] += e_m[j][i] * point.gradient_t[j][a];
              }
          }
      const auto test_rows  = rows_of<dim>(test),
                 trial_rows = rows_of<dim>(trial);
      add_products(cell,
                   n_points,
                   [&](const unsigned int i,
                       const unsigned int k,
                       const unsigned int q,
                       const unsigned int a) -> Row<n_nodes> {
                     return test_rows[i].values[q][a] * trial_rows[k].row(q);
                   });
    }

    /// Add weight {(div_t du) s:grad_t w - s:(grad_t w grad_t du)}.
    static void
    add_turned_stress(CellData<dim, degree> &cell,
                      const Kinematics      &point,
                      const unsigned int     n_points,
                      const Lanes            weight,
                      const Matrix          &stress,
                      const Lanes            pressure)
    {
      const auto &g = point.gradient_t;
      Lanes       sg[dim][n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Lanes force = pressure * g[i][a];
            for (unsigned int j = 0; j < dim; ++j)
              force += stress[i][j] * g[j][a];
            sg[i][a] = weight * force;
          }
      const auto g_rows = rows_of<dim>(g), sg_rows = rows_of<dim>(sg);
      add_products(cell,
                   n_points,
                   [&](const unsigned int i,
                       const unsigned int k,
                       const unsigned int q,
                       const unsigned int a) -> Row<n_nodes> {
                     return sg_rows[i].values[q][a] * g_rows[k].row(q) -
                            g_rows[k].values[q][a] * sg_rows[i].row(q);
                   });
    }

    /// Add c_ik grad_t w_i.grad_t du_k.
    static void
    add_laplacian(CellData<dim, degree> &cell,
                  const Kinematics      &point,
                  const unsigned int     n_points,
                  const Matrix          &c)
    {
      const auto         g = rows_of<dim>(point.gradient_t);
      alignas(64) double c_q[n_lanes_of_register][dim][dim];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          {
            const LaneValues values(c[i][k]);
            for (unsigned int q = 0; q < n_points; ++q)
              c_q[q][i][k] = values[q];
          }
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> sums[dim][dim];
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              sums[i][k] = load_row(cell.uu[i][k][a]);
          for (unsigned int q = 0; q < n_points; ++q)
            {
              Row<n_nodes> product = g[0].values[q][a] * g[0].row(q);
              for (unsigned int j = 1; j < dim; ++j)
                product += g[j].values[q][a] * g[j].row(q);
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int k = 0; k < dim; ++k)
                  sums[i][k] += c_q[q][i][k] * product;
            }
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              store_row(sums[i][k], cell.uu[i][k][a]);
        }
    }

    /// Add m du.w.
    static void
    add_inertia(CellData<dim, degree> &cell,
                const Kinematics      &point,
                const unsigned int     n_points,
                const Lanes            mass)
    {
      if (cell.lumped)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            const double weight = sum(mass * point.weight(a));
            for (unsigned int i = 0; i < dim; ++i)
              cell.uu[i][i][a][a] += weight;
            for_each_coriolis_term(cell,
                                   [&](const unsigned int i,
                                       const unsigned int k,
                                       const double       share) {
                                     cell.uu[i][k][a][a] += share * weight;
                                   });
          }
      else
        {
          const PointRows<n_nodes> N(point.N);
          const LaneValues         m(mass);
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              Row<n_nodes> row = 0.;
              for (unsigned int q = 0; q < n_points; ++q)
                row += m[q] * N.values[q][a] * N.row(q);
              for (unsigned int i = 0; i < dim; ++i)
                store_row(load_row(cell.uu[i][i][a]) + row, cell.uu[i][i][a]);
              for_each_coriolis_term(cell,
                                     [&](const unsigned int i,
                                         const unsigned int k,
                                         const double       share) {
                                       store_row(load_row(cell.uu[i][k][a]) +
                                                   share * row,
                                                 cell.uu[i][k][a]);
                                     });
            }
        }
    }

    /// Call add(i, k, C_ik) for the entries of coriolis_over_inertia() that are
    /// not zero in every frame.
    template <typename Add>
    static void
    for_each_coriolis_term(const CellData<dim, degree> &cell, const Add &add)
    {
      if (!cell.turns)
        return;
      const dealii::Tensor<2, dim> shares = cell.coriolis_over_inertia();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          if (i != k)
            add(i, k, shares[i][k]);
    }
  };
} // namespace seiche

#endif
