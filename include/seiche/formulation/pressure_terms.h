// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_pressure_terms_h
#define seiche_formulation_pressure_terms_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/point_kinematics.h>

namespace seiche
{
  /**
   * @brief Derivatives of the mixed form that the pressure takes part in, at
   * several points at once (doc/theory.md (4.7b) to (4.7e)); of the lanes the
   * first n_points count.
   */
  template <int dim, int degree>
  struct PressureTerms
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    using Kinematics                      = PointKinematics<dim, degree>;

    /// Terms between displacement and pressure that are products of two
    /// vectors: up += force grad w q, pu += weight q h + grad q inertia;
    /// @p weight [m^dim], @p force [m^dim], @p h [1/m], @p inertia [m^dim].
    static void
    add_couplings(CellData<dim, degree> &cell,
                  const Kinematics      &point,
                  const unsigned int     n_points,
                  const Lanes            force,
                  const Lanes            weight,
                  const Lanes (&h)[dim][n_nodes],
                  const Lanes (&inertia)[n_nodes])
    {
      using Rows = PointRows<n_nodes>;
      const Rows       N(point.N), inertia_rows(inertia);
      const LaneValues force_q(force), weight_q(weight);
      for (unsigned int k = 0; k < dim; ++k)
        {
          const Rows   g(point.gradient_t[k]), h_rows(h[k]);
          Row<n_nodes> up[n_nodes], pu[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              up[a] = load_row(cell.up[k][a]);
              pu[a] = load_row(cell.pu[k][a]);
            }
          for (unsigned int q = 0; q < n_points; ++q)
            {
              const Row<n_nodes> force_N  = force_q[q] * N.row(q),
                                 weight_h = weight_q[q] * h_rows.row(q);
              for (unsigned int a = 0; a < n_nodes; ++a)
                {
                  up[a] += g.values[q][a] * force_N;
                  pu[a] += N.values[q][a] * weight_h;
                  pu[a] += g.values[q][a] * inertia_rows.row(q);
                }
            }
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              store_row(up[a], cell.up[k][a]);
              store_row(pu[a], cell.pu[k][a]);
            }
        }
    }

    /// The Coriolis acceleration in the momentum's subscale: pu += grad
    /// q.(coriolis_over_inertia du) inertia; @p inertia as in add_couplings().
    static void
    add_coriolis(CellData<dim, degree> &cell,
                 const Kinematics      &point,
                 const unsigned int     n_points,
                 const Lanes (&inertia)[n_nodes])
    {
      const dealii::Tensor<2, dim> shares = cell.coriolis_over_inertia();
      const PointRows<n_nodes>     inertia_rows(inertia);
      for (unsigned int k = 0; k < dim; ++k)
        {
          Lanes turned[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              turned[a] = 0.;
              for (unsigned int i = 0; i < dim; ++i)
                turned[a] += shares[i][k] * point.gradient_t[i][a];
            }
          const PointRows<n_nodes> turned_rows(turned);
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              Row<n_nodes> pu = load_row(cell.pu[k][a]);
              for (unsigned int q = 0; q < n_points; ++q)
                pu += turned_rows.values[q][a] * inertia_rows.row(q);
              store_row(pu, cell.pu[k][a]);
            }
        }
    }

    /// pp += compliance q p + fine grad q.grad p; @p compliance V/kappa
    /// [m^dim/Pa], @p fine V_t tau1 [m^(dim+2)/Pa].
    static void
    add_diagonal(CellData<dim, degree> &cell,
                 const Kinematics      &point,
                 const unsigned int     n_points,
                 const Lanes            compliance,
                 const Lanes            fine)
    {
      const PointRows<n_nodes> N(point.N);
      const auto               g = rows_of<dim>(point.gradient_t);
      const LaneValues         compliance_q(compliance), fine_q(fine);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> pp = load_row(cell.pp[a]);
          for (unsigned int q = 0; q < n_points; ++q)
            {
              pp += fine_q[q] * gradient_product(g, q, a);
              pp += compliance_q[q] * N.values[q][a] * N.row(q);
            }
          store_row(pp, cell.pp[a]);
        }
    }

    /// The gradients of the subscale's term, V_t tau1 grad q.r, and of p in it
    /// turn with the fluid:
    /// pu += weight {(grad q.f) div du + grad q.(grad du) r - p'.(grad du)^T
    /// grad q}, p' = grad p, f = grad p + Pi r - div s [N/m^dim]; @p weight
    /// theta V_t tau1 [m^(dim+2)/Pa].
    static void
    add_turns(CellData<dim, degree>               &cell,
              const Kinematics                    &point,
              const unsigned int                   n_points,
              const Lanes                          weight,
              const dealii::Tensor<1, dim, Lanes> &f,
              const dealii::Tensor<1, dim, Lanes> &pressure_gradient,
              const dealii::Tensor<1, dim, Lanes> &r)
    {
      Lanes of_f[n_nodes], of_r[n_nodes]; // times grad N
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          of_f[a] = of_r[a] = 0.;
          for (unsigned int j = 0; j < dim; ++j)
            {
              of_f[a] += weight * f[j] * point.gradient_t[j][a];
              of_r[a] += weight * r[j] * point.gradient_t[j][a];
            }
        }
      const PointRows<n_nodes> f_rows(of_f), r_rows(of_r);
      const auto               g = rows_of<dim>(point.gradient_t);
      alignas(64) double       p[dim][n_lanes_of_register];
      for (unsigned int k = 0; k < dim; ++k)
        (weight * pressure_gradient[k])
          .copy_to(p[k], std::experimental::element_aligned);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> pu[dim];
          for (unsigned int k = 0; k < dim; ++k)
            pu[k] = load_row(cell.pu[k][a]);
          for (unsigned int q = 0; q < n_points; ++q)
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

  private:
    /// grad N_a.grad N_b at point q, for all b.
    static Row<n_nodes>
    gradient_product(const std::array<PointRows<n_nodes>, dim> &g,
                     const unsigned int                         q,
                     const unsigned int                         a)
    {
      Row<n_nodes> product = g[0].values[q][a] * g[0].row(q);
      for (unsigned int j = 1; j < dim; ++j)
        product += g[j].values[q][a] * g[j].row(q);
      return product;
    }
  };
} // namespace seiche

#endif
