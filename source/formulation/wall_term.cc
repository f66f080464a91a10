// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/wall_term.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// cof(F), F^-T det F.
    Tensor<2, 2>
    cofactor(const Tensor<2, 2> &F)
    {
      Tensor<2, 2> result;
      result[0][0] = F[1][1];
      result[0][1] = -F[1][0];
      result[1][0] = -F[0][1];
      result[1][1] = F[0][0];
      return result;
    }

    Tensor<2, 3>
    cofactor(const Tensor<2, 3> &F)
    {
      Tensor<2, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        result[i] = cross_product_3d(F[(i + 1) % 3], F[(i + 2) % 3]);
      return result;
    }

    /// The fluid at a point of a wall.
    template <int dim, int degree>
    struct FluidAtWall
    {
      PointBatch<dim, degree, double> point;
      double         gradient_t[dim][Basis<dim, degree>::n_nodes];
      Tensor<1, dim> displacement; // [m]
      double         pressure;     // [Pa]
      Tensor<1, dim> normal;       // at t_n
      Tensor<1, dim> area_t;       // n_t dA [m^(dim-1)]
      double         stiffness;    // of (n.u) [N/m]

      FluidAtWall(const CellData<dim, degree> &cell,
                  const WallPoint<dim>        &wall,
                  const double                 gamma)
      {
        point.reinit(cell.geometry, wall.unit);
        displacement           = point.value(cell.displacement);
        pressure               = point.value(cell.pressure);
        const Tensor<2, dim> F = identity_plus<dim, double>(
          cell.coefficients.theta * point.gradient(cell.displacement));
        const double area = wall.area.norm();
        normal            = wall.area / area;
        area_t            = cofactor(F) * wall.area;
        stiffness         = gamma * area * cell.geometry.shortest_edge() *
                    cell.fluid.inertia(cell.coefficients.inertia);
        const Tensor<2, dim> inverse = invert(F);
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            {
              gradient_t[i][a] = 0.;
              for (unsigned int j = 0; j < dim; ++j)
                gradient_t[i][a] += inverse[j][i] * point.gradient_n[j][a];
            }
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
        const Tensor<1, dim>           force =
          fluid.pressure * fluid.area_t +
          fluid.stiffness * (fluid.normal * fluid.displacement) * fluid.normal;
        const double through = fluid.area_t * fluid.displacement;
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          {
            for (unsigned int i = 0; i < dim; ++i)
              cell.residual_u[i][a] += fluid.point.N[a] * force[i];
            cell.residual_p[a] -= fluid.point.N[a] * through;
          }
        cell.solid_reactions.push_back(
          {wall.solid,
           cell.geometry.to_real(wall.unit) +
             cell.coefficients.theta * fluid.displacement,
           -force});
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
        const auto                    &N       = fluid.point.N;
        const auto                    &g       = fluid.gradient_t;
        const auto                    &n_t     = fluid.area_t;
        const auto                    &u       = fluid.displacement;
        const double                   through = n_t * u;
        for (unsigned int b = 0; b < cell.n_nodes; ++b)
          {
            double along = 0.; // g_b.u
            for (unsigned int i = 0; i < dim; ++i)
              along += g[i][b] * u[i];
            for (unsigned int k = 0; k < dim; ++k)
              {
                const double of_volume =
                  N[b] * n_t[k] + theta * (through * g[k][b] - n_t[k] * along);
                for (unsigned int a = 0; a < cell.n_nodes; ++a)
                  {
                    for (unsigned int i = 0; i < dim; ++i)
                      cell.uu[i][k][a][b] +=
                        N[a] * (theta * fluid.pressure *
                                  (n_t[i] * g[k][b] - n_t[k] * g[i][b]) +
                                fluid.stiffness * fluid.normal[i] *
                                  fluid.normal[k] * N[b]);
                    cell.up[k][a][b] += N[a] * N[b] * n_t[k];
                    cell.pu[k][a][b] -= N[a] * of_volume;
                  }
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
