// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/point_boxes.h>
#include <seiche/utilities/shape_functions.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  PointBoxes<dim>::PointBoxes(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
  {}

  template <int dim>
  typename PointBoxes<dim>::Parts
  PointBoxes<dim>::divide(const unsigned int cell,
                          const unsigned int direction,
                          const double       centre,
                          const double       edge) const
  {
    constexpr double touches = 1e-12; // the face, up to round-off
    const auto       is_wall = [&](const unsigned int side) {
      return occupancy.locator.neighbor(cell, 2 * direction + side) ==
             CellLocator<dim>::invalid;
    };
    double lower = centre - 0.5 * edge;
    if (lower < 0. && is_wall(0))
      lower = 0.;
    if (lower + edge > 1. && is_wall(1))
      lower = 1. - edge;
    const double upper = lower + edge;
    if (lower >= -touches && upper <= 1. + touches)
      return {1, {0.5 * (lower + upper), 0.}, {1., 0.}};
    const double face = lower < 0. ? 0. : 1.;
    return {2,
            {0.5 * (lower + face), 0.5 * (face + upper)},
            {(face - lower) / edge, (upper - face) / edge}};
  }

  template <int dim>
  void
  PointBoxes<dim>::add(const unsigned int               cell,
                       const Point<dim>                &unit,
                       const double                     volume,
                       typename Occupancy<dim>::Vector &sums) const
  {
    using Shape          = TensorShape<dim, 1>;
    const auto  &locator = occupancy.locator;
    const double edge =
      std::min(1., std::pow(volume / locator.measure(cell), 1. / dim));
    Parts parts[dim];
    for (unsigned int d = 0; d < dim; ++d)
      parts[d] = divide(cell, d, unit[d], edge);
    for (unsigned int part = 0; part < (1u << dim); ++part)
      {
        double     share = 1.;
        Point<dim> place;
        bool       exists = true;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int i = (part >> d) & 1u;
            exists               = exists && i < parts[d].n;
            share *= parts[d].share[i];
            place[d] = locator.lower_corner(cell)[d] +
                       parts[d].centre[i] * locator.extent(cell)[d];
          }
        if (!exists)
          continue;
        unsigned int holder =
          locator.holds(cell, place) ? cell : locator.find(place, cell);
        if (holder == CellLocator<dim>::invalid)
          holder = cell; // around the edge of an obstacle
        Point<dim> in_holder = locator.to_unit(holder, place);
        for (unsigned int d = 0; d < dim; ++d)
          in_holder[d] = std::clamp(in_holder[d], 0., 1.);
        double N[Shape::n_nodes], nodal[HangingNodes<dim>::max_nodes] = {};
        Shape::values(in_holder, N);
        for (unsigned int v = 0; v < Shape::n_nodes; ++v)
          nodal[occupancy.vertex_node(v)] = N[v] * share * volume;
        occupancy.condense(holder, nodal);
        const unsigned int *nodes = occupancy.cell_nodes(holder);
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          sums.local_element(nodes[a]) += nodal[a];
      }
  }

  template class PointBoxes<2>;
  template class PointBoxes<3>;
} // namespace seiche
