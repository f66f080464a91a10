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
  unsigned int
  PointBoxes<dim>::divide(const unsigned int   cell,
                          const unsigned int   direction,
                          const double         centre,
                          const double         edge,
                          std::array<Part, 2> &parts) const
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
      {
        parts[0] = {1, 0.5 * (lower + upper), 1.};
        return 1;
      }
    const bool   below = lower < 0.;
    const double face  = below ? 0. : 1.;
    parts = {{{below ? 0u : 1u, 0.5 * (lower + face), (face - lower) / edge},
              {below ? 1u : 2u, 0.5 * (face + upper), (upper - face) / edge}}};
    return 2;
  }

  template <int dim>
  unsigned int
  PointBoxes<dim>::find_holder(const unsigned int cell,
                               const unsigned int side) const
  {
    const auto &locator = occupancy.locator;
    // of smaller cells only those that touch this one are ghosts
    constexpr double near[] = {-0.25, 0.25, 1.25};
    Point<dim>       place  = locator.lower_corner(cell);
    for (unsigned int d = 0, rest = side; d < dim; ++d, rest /= 3)
      place[d] += near[rest % 3] * locator.extent(cell)[d];
    const unsigned int found =
      locator.holds(cell, place) ? cell : locator.find(place, cell);
    if (found == CellLocator<dim>::invalid)
      return cell;
    const double difference =
      std::abs(locator.measure(found) - locator.measure(cell));
    return difference < 1e-6 * locator.measure(cell) ? found : locator.invalid;
  }

  template <int dim>
  void
  PointBoxes<dim>::add_to(const unsigned int                   cell,
                          const std::array<double, 1u << dim> &of_vertices,
                          typename Occupancy<dim>::Vector     &sums) const
  {
    double nodal[HangingNodes<dim>::max_nodes] = {};
    for (unsigned int v = 0; v < of_vertices.size(); ++v)
      nodal[occupancy.vertex_node(v)] = of_vertices[v];
    occupancy.condense(cell, nodal);
    const unsigned int *nodes = occupancy.cell_nodes(cell);
    for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
      sums.local_element(nodes[a]) += nodal[a];
  }

  template <int dim>
  void
  PointBoxes<dim>::add_part(const unsigned int               cell,
                            const std::array<Part, dim>     &part,
                            double                           volume,
                            Integrals                       &integrals,
                            typename Occupancy<dim>::Vector &sums) const
  {
    using Shape          = TensorShape<dim, 1>;
    const auto  &locator = occupancy.locator;
    unsigned int side    = 0;
    for (unsigned int d = dim; d-- > 0;)
      {
        side = 3 * side + part[d].side;
        volume *= part[d].share;
      }
    if (!integrals.exists[side])
      {
        integrals.exists[side] = true;
        integrals.holder[side] = find_holder(cell, side);
        integrals.of_vertices[side].fill(0.);
      }
    unsigned int holder       = integrals.holder[side];
    const bool   is_same_size = holder != locator.invalid;
    Point<dim>   unit;
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = part[d].centre +
                (is_same_size && holder != cell ? 1. - part[d].side : 0.);
    if (!is_same_size)
      {
        Point<dim> place = locator.lower_corner(cell);
        for (unsigned int d = 0; d < dim; ++d)
          place[d] += unit[d] * locator.extent(cell)[d];
        holder = locator.find(place, cell);
        if (holder == locator.invalid)
          holder = cell;
        unit = locator.to_unit(holder, place);
      }
    for (unsigned int d = 0; d < dim; ++d)
      unit[d] = std::clamp(unit[d], 0., 1.);
    std::array<double, Shape::n_nodes> N;
    Shape::values(unit, N.data());
    for (double &value : N)
      value *= volume;
    if (!is_same_size)
      add_to(holder, N, sums);
    else
      for (unsigned int v = 0; v < Shape::n_nodes; ++v)
        integrals.of_vertices[side][v] += N[v];
  }

  template <int dim>
  void
  PointBoxes<dim>::add(const PointCloud<dim>           &points,
                       const double                    *volume,
                       const unsigned int               cell,
                       typename Occupancy<dim>::Vector &sums) const
  {
    using Shape                    = TensorShape<dim, 1>;
    const auto            &locator = occupancy.locator;
    constexpr unsigned int here    = n_sides / 2;
    Integrals              integrals;
    integrals.exists[here] = true;
    integrals.holder[here] = cell;
    auto &of_vertices      = integrals.of_vertices[here];
    of_vertices.fill(0.);
    double ratio = 0., edge = 0.;
    for (std::size_t p = points.first_point(cell);
         p < points.first_point(cell + 1);
         ++p)
      {
        const Point<dim> unit = locator.to_unit(cell, points.position(p));
        if (const double now = volume[p] / locator.measure(cell); now != ratio)
          {
            ratio = now; // mostly that of the point before
            edge = std::min(1., dim == 2 ? std::sqrt(ratio) : std::cbrt(ratio));
          }
        bool is_inside = true; // the mean of a hat is its value at the centre
        for (unsigned int d = 0; d < dim; ++d)
          is_inside =
            is_inside && std::abs(unit[d] - 0.5) <= 0.5 * (1. - edge) + 1e-12;
        if (is_inside)
          {
            double N[Shape::n_nodes];
            Shape::values(unit, N);
            for (unsigned int v = 0; v < Shape::n_nodes; ++v)
              of_vertices[v] += N[v] * volume[p];
            continue;
          }
        std::array<Part, 2> along[dim];
        unsigned int        n[dim], n_parts = 1;
        for (unsigned int d = 0; d < dim; ++d)
          {
            n[d] = divide(cell, d, unit[d], edge, along[d]);
            n_parts *= n[d];
          }
        std::array<Part, dim> part;
        for (unsigned int i = 0; i < n_parts; ++i)
          {
            for (unsigned int d = 0, rest = i; d < dim; rest /= n[d], ++d)
              part[d] = along[d][rest % n[d]];
            add_part(cell, part, volume[p], integrals, sums);
          }
      }
    for (unsigned int side = 0; side < n_sides; ++side)
      if (integrals.exists[side] && integrals.holder[side] != locator.invalid)
        add_to(integrals.holder[side], integrals.of_vertices[side], sums);
  }

  template class PointBoxes<2>;
  template class PointBoxes<3>;
} // namespace seiche
