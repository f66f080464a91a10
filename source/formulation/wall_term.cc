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

      /// (u - g).area, of one of both, by the displacement of node b along k.
      double
      through_slope(const CellData<dim, degree> &cell,
                    const Tensor<1, dim>        &of_area,
                    const unsigned int           k,
                    const unsigned int           b) const
      {
        double along = 0.; // gradient.(u - g)
        for (unsigned int i = 0; i < dim; ++i)
          along += gradient_t[i][b] * relative[i];
        return point.N[b] * (of_area * relative_slope)[k] +
               cell.coefficients.theta *
                 ((of_area * relative) * gradient_t[k][b] - of_area[k] * along);
      }
    };
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
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          {
            for (unsigned int i = 0; i < dim; ++i)
              cell.residual_u[i][a] += fluid.point.N[a] * force[i];
            cell.residual_p[a] -= fluid.point.N[a] * through;
          }
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
        for (unsigned int b = 0; b < cell.n_nodes; ++b)
          for (unsigned int k = 0; k < dim; ++k)
            {
              const double of_volume = fluid.through_slope(cell, n_t, k, b),
                           of_gap    = fluid.through_slope(cell, m_t, k, b);
              for (unsigned int i = 0; i < dim; ++i)
                {
                  const double of_force =
                    theta * fluid.pressure *
                      (n_t[i] * g[k][b] - n_t[k] * g[i][b]) +
                    fluid.stiffness *
                      (of_gap * m_t[i] +
                       theta * gap * (m_t[i] * g[k][b] - m_t[k] * g[i][b]));
                  for (unsigned int a = 0; a < cell.n_nodes; ++a)
                    cell.uu[i][k][a][b] += N[a] * of_force;
                }
              for (unsigned int a = 0; a < cell.n_nodes; ++a)
                {
                  cell.up[k][a][b] += N[a] * N[b] * n_t[k];
                  cell.pu[k][a][b] -= N[a] * of_volume;
                }
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
