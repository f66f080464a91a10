// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/point_shift.h>
#include <seiche/grid/shifting.h>
#include <seiche/utilities/shape_functions.h>

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
    using Shape                       = TensorShape<dim, 1>;
    constexpr unsigned int n_vertices = Shape::n_nodes;
    const auto            &locator    = occupancy.locator;
    excess.assign(locator.n_cells(), 0.);
    for (const unsigned int cell : occupancy.occupied_cells())
      excess[cell] = fill.cell_fill(cell) - fill.inside_share(cell);
    locator.exchange_to_ghosts(excess);

    double N[n_vertices], dN[n_vertices][dim];
    double f[HangingNodes<dim>::max_nodes], s[HangingNodes<dim>::max_nodes];
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        if (fill.is_cut(cell))
          continue;
        const unsigned int *nodes = occupancy.cell_nodes(cell);
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          {
            f[a] = fill.nodal_fill().local_element(nodes[a]) -
                   fill.inside_fill(nodes[a]);
            s[a] = fill.inner_nodes().local_element(nodes[a]);
          }
        occupancy.expand(cell, f);
        occupancy.expand(cell, s);

        // of the cells' excess, across the lower and the upper face
        double jump[dim][2] = {};
        for (unsigned int d = 0; d < dim; ++d)
          for (const unsigned int side : {0, 1})
            {
              const unsigned int other = locator.neighbor(cell, 2 * d + side);
              if (other != locator.invalid)
                jump[d][side] =
                  (side == 0 ? -1. : 1.) * (excess[other] - excess[cell]);
            }

        const PointShift<dim> shift(cell, points);
        for (std::size_t p = points.first_point(cell);
             p < points.first_point(cell + 1);
             ++p)
          {
            const Point<dim> unit = locator.to_unit(cell, points.position(p));
            Shape::evaluate(unit, N, dN);
            double         weight = 0.;
            Tensor<1, dim> delta;
            for (unsigned int v = 0; v < n_vertices; ++v)
              {
                const unsigned int node = occupancy.vertex_node(v);
                weight += N[v] * s[node];
                for (unsigned int d = 0; d < dim; ++d)
                  delta[d] -= strength * dN[v][d] * f[node];
              }
            for (unsigned int d = 0; d < dim; ++d)
              delta[d] -= strength * cell_share *
                          ((1. - unit[d]) * jump[d][0] + unit[d] * jump[d][1]);
            for (unsigned int d = 0; d < dim; ++d)
              delta[d] =
                std::clamp(weight * delta[d], -longest_shift, longest_shift);
            shift.apply(p, delta);
          }
      }
  }

  template class Shifting<2>;
  template class Shifting<3>;
} // namespace seiche
