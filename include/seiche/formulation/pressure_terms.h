// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_pressure_terms_h
#define seiche_formulation_pressure_terms_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/point_kinematics.h>

namespace seiche
{
  /**
   * @brief Derivatives of the mixed form that the pressure takes part in, at
   * several points at once; of the lanes the first n_points count.
   */
  template <int dim, int degree>
  struct PressureTerms
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    using Kinematics                      = PointKinematics<dim, degree, Lanes>;

    /// Terms between displacement and pressure that are products of two
    /// vectors: up += force grad w q, pu += weight q h + grad q of_g + gp grad.
    static void
    add_couplings(CellData<dim, degree> &cell,
                  const Kinematics      &point,
                  const unsigned int     n_points,
                  const Lanes            force,
                  const Lanes            weight,
                  const Lanes (&h)[dim][n_nodes],
                  const Lanes (&of_g)[n_nodes],
                  const Lanes (&gp)[n_nodes])
    {
      using Rows = PointRows<n_nodes>;
      const Rows       N(point.N), gp_rows(gp), of_g_rows(of_g);
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
                  pu[a] += g.values[q][a] * of_g_rows.row(q);
                  pu[a] += gp_rows.values[q][a] * g.row(q);
                }
            }
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              store_row(up[a], cell.up[k][a]);
              store_row(pu[a], cell.pu[k][a]);
            }
        }
    }

    /// Terms with the product of two gradients, and the mass of the pressure:
    /// pp += weight q p + fine grad q.grad p, pu_k += factor_k fine grad
    /// q.grad.
    static void
    add_gradients(CellData<dim, degree>               &cell,
                  const Kinematics                    &point,
                  const unsigned int                   n_points,
                  const Lanes                          weight,
                  const Lanes                          fine,
                  const dealii::Tensor<1, dim, Lanes> &factor)
    {
      const PointRows<n_nodes> N(point.N);
      const auto               g = rows_of<dim>(point.gradient_t);
      const LaneValues         weight_q(weight), fine_q(fine);
      alignas(64) double       factor_q[dim][n_lanes_of_register];
      for (unsigned int k = 0; k < dim; ++k)
        factor[k].copy_to(factor_q[k], std::experimental::element_aligned);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> pp = load_row(cell.pp[a]), pu[dim];
          for (unsigned int k = 0; k < dim; ++k)
            pu[k] = load_row(cell.pu[k][a]);
          for (unsigned int q = 0; q < n_points; ++q)
            {
              Row<n_nodes> product = g[0].values[q][a] * g[0].row(q);
              for (unsigned int j = 1; j < dim; ++j)
                product += g[j].values[q][a] * g[j].row(q);
              product *= fine_q[q];
              pp += product;
              pp += weight_q[q] * N.values[q][a] * N.row(q);
              for (unsigned int k = 0; k < dim; ++k)
                pu[k] += factor_q[k][q] * product;
            }
          store_row(pp, cell.pp[a]);
          for (unsigned int k = 0; k < dim; ++k)
            store_row(pu[k], cell.pu[k][a]);
        }
    }
  };
} // namespace seiche

#endif
