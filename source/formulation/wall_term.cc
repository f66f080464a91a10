// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/cofactor.h>
#include <seiche/formulation/wall_term.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The fluid at a point of a wall.
    template <int dim, int degree>
    struct FluidAtWall
    {
      PointBatch<dim, degree, double> point;
      double         gradient_t[dim][Basis<dim, degree>::n_nodes];
      Point<dim>     place;          // in the configuration of the forces [m]
      Tensor<1, dim> way_of_wall;    // g [m]
      Tensor<1, dim> relative;       // u - g [m]
      Tensor<2, dim> relative_slope; // its derivative by u
      Tensor<1, dim> area;           // n_t dA [m^(dim-1)]
      Tensor<1, dim> solid_area;     // m_t dA
      double         stiffness;      // of the latter [Pa/m^dim]
      double         pressure;       // [Pa]

      FluidAtWall(const CellData<dim, degree> &cell,
                  const WallPoint<dim>        &wall,
                  const double                 gamma)
      {
        point.reinit(cell.geometry, wall.unit);
        const double         theta = cell.coefficients.theta;
        const RigidWay<dim> &way   = (*cell.solids)[wall.solid].way;
        const Tensor<1, dim> u     = point.value(cell.displacement);
        place          = cell.geometry.to_real(wall.unit) + theta * u;
        way_of_wall    = way.at(place);
        relative       = u - way_of_wall;
        relative_slope = identity_plus<dim, double>(-theta * way.turn);
        const Tensor<2, dim> F =
          identity_plus<dim, double>(theta * point.gradient(cell.displacement));
        const Tensor<2, dim> turn = cofactor(F);
        const double         dA   = wall.area.norm();
        area                      = turn * wall.area;
        solid_area                = turn * (dA * wall.normal);
        stiffness                 = gamma * cell.geometry.shortest_edge() *
                    cell.fluid.inertia(cell.coefficients.inertia) / dA;
        if (cell.wall_is_dry)
          area = 0.; // drops fill no cell
        pressure                     = point.value(cell.pressure);
        const Tensor<2, dim> inverse = invert(F);
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            {
              gradient_t[i][a] = 0.;
              for (unsigned int j = 0; j < dim; ++j)
                gradient_t[i][a] += inverse[j][i] * point.gradient_n[j][a];
            }
      }

      /// (u - g).area, of one of both, by the displacements of the nodes along
      /// k.
      Row<Basis<dim, degree>::n_nodes>
      through_slope(const CellData<dim, degree> &cell,
                    const Tensor<1, dim>        &of_area,
                    const unsigned int           k) const
      {
        auto along = relative[0] * load_row(gradient_t[0]); // gradient.(u - g)
        for (unsigned int i = 1; i < dim; ++i)
          along += relative[i] * load_row(gradient_t[i]);
        return (of_area * relative_slope)[k] * load_row(point.N) +
               cell.coefficients.theta *
                 ((of_area * relative) * load_row(gradient_t[k]) -
                  of_area[k] * along);
      }
    };

    /// N_a row_b to a block of the cell's matrix.
    template <unsigned int n>
    void
    add_product(double (&block)[n][n], const double (&N)[n], const Row<n> &row)
    {
      for (unsigned int a = 0; a < n; ++a)
        store_row(load_row(block[a]) + N[a] * row, block[a]);
    }
  } // namespace

  template <int dim, int degree>
  void
  WallTerm::add_cell_residual(CellData<dim, degree> &cell) const
  {
    if (cell.wall == nullptr)
      return;
    for (const WallPoint<dim> &wall : *cell.wall)
      {
        const FluidAtWall<dim, degree> fluid(cell, wall, gamma);
        const double                   through = fluid.area * fluid.relative;
        const Tensor<1, dim>           force =
          fluid.pressure * fluid.area + fluid.stiffness *
                                          (fluid.solid_area * fluid.relative) *
                                          fluid.solid_area;
        const auto N = load_row(fluid.point.N);
        for (unsigned int i = 0; i < dim; ++i)
          store_row(load_row(cell.residual_u[i]) + force[i] * N,
                    cell.residual_u[i]);
        store_row(load_row(cell.residual_p) - through * N, cell.residual_p);
        cell.solid_reactions.push_back(
          {wall.solid, fluid.place, -force, -(force * fluid.way_of_wall)});
      }
  }

  template <int dim, int degree>
  void
  WallTerm::add_cell_tangent(CellData<dim, degree> &cell) const
  {
    if (cell.wall == nullptr)
      return;
    const double theta = cell.coefficients.theta;
    for (const WallPoint<dim> &wall : *cell.wall)
      {
        const FluidAtWall<dim, degree> fluid(cell, wall, gamma);
        const auto                    &N   = fluid.point.N;
        const auto                    &g   = fluid.gradient_t;
        const auto                    &n_t = fluid.area;
        const auto                    &m_t = fluid.solid_area;
        const double                   gap = m_t * fluid.relative;
        for (unsigned int k = 0; k < dim; ++k)
          {
            const auto of_gap = fluid.through_slope(cell, m_t, k);
            const auto g_k    = load_row(g[k]);
            for (unsigned int i = 0; i < dim; ++i)
              {
                const auto g_i = load_row(g[i]);
                add_product(cell.uu[i][k],
                            N,
                            theta * fluid.pressure *
                                (n_t[i] * g_k - n_t[k] * g_i) +
                              fluid.stiffness *
                                (m_t[i] * of_gap +
                                 theta * gap * (m_t[i] * g_k - m_t[k] * g_i)));
              }
            add_product(cell.up[k], N, n_t[k] * load_row(N));
            add_product(cell.pu[k], N, -fluid.through_slope(cell, n_t, k));
          }
      }
  }

#define INSTANTIATE(dim, degree)                                            \
  template void WallTerm::add_cell_residual(CellData<dim, degree> &) const; \
  template void WallTerm::add_cell_tangent(CellData<dim, degree> &) const;
  INSTANTIATE(2, 1)
  INSTANTIATE(2, 2)
  INSTANTIATE(3, 1)
  INSTANTIATE(3, 2)
#undef INSTANTIATE
} // namespace seiche
