// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/point_shift.h>
#include <seiche/grid/shifting.h>
#include <seiche/space/point_batch.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double longest_shift = 0.25; // of the cell, each direction
    constexpr double cell_share    = 0.2;  // of the cell fill's gradient
  }                                        // namespace

  template <int dim>
  Shifting<dim>::Shifting(const Fill<dim> &grid_fill,
                          const double     shifting_strength)
    : fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , strength(shifting_strength)
  {}

  template <int dim>
  void
  Shifting<dim>::sweep(PointCloud<dim> &points)
  {
    PointBatch<dim, 1, double> point;
    constexpr unsigned int     n_vertices = point.n_nodes;
    const auto                &locator    = occupancy.locator;
    const auto                 domain     = locator.lines.domain();
    excess.assign(locator.cells.size(), 0.);
    for (const unsigned int cell : occupancy.cells.occupied())
      excess[cell] = fill.cell_fill(cell) - fill.inside_share(cell);
    locator.cells.exchange_to_ghosts(excess);

    double f[n_vertices], f_h[n_vertices], s[n_vertices];
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (fill.is_cut(cell))
          continue;
        occupancy.vertex_values(cell, fill.nodal_fill(), f);
        occupancy.vertex_values(cell, fill.inner_nodes(), s);
        if (fill.has_surface())
          {
            occupancy.vertex_values(cell, fill.surface().nodal_fill(), f_h);
            for (unsigned int v = 0; v < n_vertices; ++v)
              f[v] -= f_h[v];
          }

        // of the cells' excess, across the lower and the upper face
        double jump[dim][2] = {};
        for (unsigned int d = 0; d < dim; ++d)
          for (const unsigned int side : {0, 1})
            {
              const unsigned int other =
                locator.cells.neighbor(cell, BoxFace(d, side));
              if (other != locator.invalid)
                jump[d][side] =
                  (side == 0 ? -1. : 1.) * (excess[other] - excess[cell]);
            }

        const CellGeometry<dim> &geometry = locator.cells.geometry(cell);
        const PointShift<dim>    shift(cell, points, domain);
        for (const std::size_t p : points.points_in(cell))
          {
            const Point<dim> unit = geometry.to_unit(points.position(p));
            point.reinit(geometry, unit);
            const double         weight = point.value(s);
            const Tensor<1, dim> slope  = geometry.to_real(point.gradient(f));
            Tensor<1, dim>       delta; // [cells]
            for (unsigned int d = 0; d < dim; ++d)
              delta[d] =
                std::clamp(-strength * weight *
                             (slope[d] +
                              cell_share * ((1. - unit[d]) * jump[d][0] +
                                            unit[d] * jump[d][1])),
                           -longest_shift,
                           longest_shift);
            shift.apply(p, delta, /*velocity_share=*/1.);
          }
      }
  }

  template class Shifting<2>;
  template class Shifting<3>;
} // namespace seiche
