// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/fluid_at_wall.h>
#include <seiche/formulation/wall_term.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim, int degree>
    bool
    leaves(const WallTerm                 &term,
           const CellData<dim, degree>    &cell,
           const WallPoint<dim>           &wall,
           const FluidAtWall<dim, degree> &fluid)
    {
      if (!fluid.may_leave(cell, wall))
        return false;
      const bool presses = term.old_pressure_presses && !cell.wall_is_dry;
      return fluid.leaves(cell,
                          wall,
                          presses ?
                            std::max(0., fluid.point.value(cell.old_pressure)) :
                            0.);
    }

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
        const FluidAtWall<dim, degree> fluid(cell, wall);
        const auto                     N = load_row(fluid.point.N);
        if (leaves(*this, cell, wall, fluid))
          {
            store_row(load_row(cell.residual_p) +
                        (fluid.pressure / fluid.stiffness) * N,
                      cell.residual_p);
            continue;
          }
        const double         through = fluid.area * fluid.relative;
        const Tensor<1, dim> force =
          fluid.pressure * fluid.area + fluid.stiffness *
                                          (fluid.solid_area * fluid.relative) *
                                          fluid.solid_area;
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
        const FluidAtWall<dim, degree> fluid(cell, wall);
        const auto                    &N = fluid.point.N;
        if (leaves(*this, cell, wall, fluid))
          {
            if (!cell.wall_is_dry)
              add_product(cell.pp, N, (1. / fluid.stiffness) * load_row(N));
            continue;
          }
        const auto  &g   = fluid.gradient_t;
        const auto  &n_t = fluid.area;
        const auto  &m_t = fluid.solid_area;
        const double gap = m_t * fluid.relative;
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
