// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_tangent_sums_h
#define seiche_formulation_tangent_sums_h

#include <seiche/formulation/point_state.h>

namespace seiche
{
  /// uu_ik[a][b] += term(i, k, q, a)[b], of the first points of the lanes.
  template <int dim, int degree, typename Product>
  void
  add_products(CellData<dim, degree> &cell,
               const unsigned int     n_points,
               const Product         &product)
  {
    constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int k = 0; k < dim; ++k)
        {
          Row<n_nodes> sums[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            sums[a] = load_row(cell.uu[i][k][a]);
          for (unsigned int q = 0; q < n_points; ++q)
            for (unsigned int a = 0; a < n_nodes; ++a)
              sums[a] += product(i, k, q, a);
          for (unsigned int a = 0; a < n_nodes; ++a)
            store_row(sums[a], cell.uu[i][k][a]);
        }
  }

  /// grad N_a.grad N_b at point q, for all b.
  template <std::size_t dim, unsigned int n_nodes>
  Row<n_nodes>
  gradient_product(const std::array<PointRows<n_nodes>, dim> &g,
                   const unsigned int                         q,
                   const unsigned int                         a)
  {
    Row<n_nodes> product = g[0].values[q][a] * g[0].row(q);
    for (unsigned int j = 1; j < dim; ++j)
      product += g[j].values[q][a] * g[j].row(q);
    return product;
  }

  /**
   * @brief Factors of products of test and trial functions in which several
   * terms have a share, at several points: each product is formed once
   * (doc/theory.md (4.7a) to (4.7d)). dg: PointState::g_slope.
   */
  template <int dim, int degree>
  struct TangentSums
  {
    static constexpr unsigned int n_nodes = CellData<dim, degree>::n_nodes;

    Lanes bulk = 0.; ///< div_t w dg [N m]
    Lanes turn = 0.; ///< w_i,k du_k,i - (div_t w) (div_t du) [N m]

    /// div_t w du [N], beside bulk.
    Lanes divergence[dim][n_nodes] = {};

    Lanes pressure   = 0.; ///< div_t w dp [m^dim]
    Lanes volume     = 0.; ///< q dg [m^dim]
    Lanes inertia    = 0.; ///< grad_t q du [m^dim]
    Lanes compliance = 0.; ///< q dp [m^dim/Pa]
    Lanes diffusion  = 0.; ///< grad_t q.grad_t dp [m^(dim+2)/Pa]

    /// To the block uu.
    void
    add_to_displacement(const PointState<dim, degree> &state,
                        CellData<dim, degree>         &cell) const
    {
      const auto        &gradient = state.point.gradient_t;
      const unsigned int n_points = state.n_points;
      Lanes              h[dim][n_nodes], turned[dim][n_nodes];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            h[i][a]      = bulk * state.g_slope[i][a] + divergence[i][a];
            turned[i][a] = turn * gradient[i][a];
          }
      const auto g = rows_of<dim>(gradient), h_rows = rows_of<dim>(h),
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
          // the turn is antisymmetric in i and k
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

    /// To the blocks up, pu, pp.
    void
    add_to_pressure(const PointState<dim, degree> &state,
                    CellData<dim, degree>         &cell) const
    {
      using Rows                  = PointRows<n_nodes>;
      const auto        &point    = state.point;
      const unsigned int n_points = state.n_points;
      Lanes              inertia_N[n_nodes];
      for (unsigned int a = 0; a < n_nodes; ++a)
        inertia_N[a] = inertia * point.N[a];
      const Rows       N(point.N), inertia_rows(inertia_N);
      const auto       g = rows_of<dim>(point.gradient_t);
      const LaneValues pressure_q(pressure), volume_q(volume),
        compliance_q(compliance), diffusion_q(diffusion);
      for (unsigned int k = 0; k < dim; ++k)
        {
          const Rows   slope(state.g_slope[k]);
          Row<n_nodes> up[n_nodes], pu[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              up[a] = load_row(cell.up[k][a]);
              pu[a] = load_row(cell.pu[k][a]);
            }
          for (unsigned int q = 0; q < n_points; ++q)
            {
              const Row<n_nodes> pressure_N   = pressure_q[q] * N.row(q),
                                 volume_slope = volume_q[q] * slope.row(q);
              for (unsigned int a = 0; a < n_nodes; ++a)
                {
                  up[a] += g[k].values[q][a] * pressure_N;
                  pu[a] += N.values[q][a] * volume_slope;
                  pu[a] += g[k].values[q][a] * inertia_rows.row(q);
                }
            }
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              store_row(up[a], cell.up[k][a]);
              store_row(pu[a], cell.pu[k][a]);
            }
        }
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          Row<n_nodes> pp = load_row(cell.pp[a]);
          for (unsigned int q = 0; q < n_points; ++q)
            {
              pp += diffusion_q[q] * gradient_product(g, q, a);
              pp += compliance_q[q] * N.values[q][a] * N.row(q);
            }
          store_row(pp, cell.pp[a]);
        }
    }
  };
} // namespace seiche

#endif
