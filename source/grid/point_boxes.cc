// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/point_boxes.h>
#include <seiche/space/point_batch.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double touches = 1e-12; // a face, up to round-off [cells]
    constexpr double beside  = 1e-6;  // a face, in the next cell [cells]

    /// A part of a box between lines of any mesh around its cell, whose levels
    /// differ by one at most: it lies in one cell.
    struct Piece
    {
      double middle; // in the unit cell
      double share;  // of the box
    };

    /// The pieces of a part [PointBoxes::Part]; their number.
    template <typename Part>
    unsigned int
    cut(const Part &part, const double edge, Piece (&pieces)[4])
    {
      unsigned int n   = 0;
      const auto   add = [&](const double from, const double to) {
        if (to > from)
          pieces[n++] = {0.5 * (from + to), (to - from) / edge};
      };
      const auto halves = [&](const double from, const double to) {
        add(from, part.side == 1 ? std::min(to, 0.5) : to);
        if (part.side == 1)
          add(std::max(from, 0.5), to);
      };
      halves(part.from, part.to);
      halves(part.fold_from, part.fold_to);
      return n;
    }
  } // namespace

  template <int dim>
  PointBoxes<dim>::PointBoxes(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
  {}

  template <int dim>
  unsigned int
  PointBoxes<dim>::divide(const unsigned int cell,
                          const unsigned int direction,
                          const double       centre,
                          const double       edge,
                          Part (&parts)[2]) const
  {
    const auto is_wall = [&](const unsigned int side) {
      return occupancy.locator.cells.wall_at(cell, BoxFace(direction, side));
    };
    // of a hat the mean over an interval is the value in its middle
    const auto part =
      [edge](const unsigned int side, const double from, const double to) {
        const double share  = edge > 0. ? (to - from) / edge : 1.;
        const double middle = 0.5 * (from + to) + 1. - side;
        return Part{
          side, {share * (1. - middle), share * middle}, from, to, 0., 0.};
      };
    const double lower = centre - 0.5 * edge, upper = lower + edge;
    if (lower >= -touches && upper <= 1. + touches)
      {
        parts[0] = part(1, lower, upper);
        return 1;
      }
    // folded back at a wall: boxes that overlap fill the cells beside it evenly
    const auto folded = [&](const Part &inside, const Part &beyond) {
      return Part{1,
                  {inside.hats[0] + beyond.hats[0],
                   inside.hats[1] + beyond.hats[1]},
                  inside.from,
                  inside.to,
                  beyond.from,
                  beyond.to};
    };
    if (lower < 0. && is_wall(0))
      {
        parts[0] = folded(part(1, 0., upper), part(1, 0., -lower));
        return 1;
      }
    if (upper > 1. && is_wall(1))
      {
        parts[0] = folded(part(1, lower, 1.), part(1, 2. - upper, 1.));
        return 1;
      }
    const bool is_below = lower < 0.;
    parts[0]            = is_below ? part(0, lower, 0.) : part(1, lower, 1.);
    parts[1]            = is_below ? part(1, 0., upper) : part(2, 1., upper);
    return 2;
  }

  template <int dim>
  unsigned int
  PointBoxes<dim>::find_touching(const unsigned int cell,
                                 const Point<dim>  &unit) const
  {
    const auto &locator = occupancy.locator;
    Point<dim>  near    = unit;
    for (unsigned int d = 0; d < dim; ++d)
      near[d] = std::clamp(unit[d], -beside, 1. + beside);
    const Point<dim> place = locator.cells.geometry(cell).to_real(near);
    if (locator.cells.geometry(cell).holds(place))
      return cell;
    const unsigned int found = locator.find(place, cell);
    return found == locator.invalid ? cell : found;
  }

  template <int dim>
  unsigned int
  PointBoxes<dim>::find_holder(const unsigned int cell,
                               const unsigned int side) const
  {
    const auto      &locator = occupancy.locator;
    constexpr double near[]  = {-0.25, 0.25, 1.25};
    Point<dim>       unit;
    for (unsigned int d = 0, rest = side; d < dim; ++d, rest /= 3)
      unit[d] = near[rest % 3];
    const unsigned int found = find_touching(cell, unit);
    if (!locator.cells.geometry(found).is_congruent(
          locator.cells.geometry(cell)))
      return locator.invalid;
    return found;
  }

  template <int dim>
  void
  PointBoxes<dim>::add_elsewhere(const unsigned int               cell,
                                 const std::array<Part, dim>     &part,
                                 const double                     edge,
                                 const double                     volume,
                                 typename Occupancy<dim>::Vector &sums) const
  {
    Piece        along[dim][4];
    unsigned int n[dim], n_pieces = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n[d] = cut(part[d], edge, along[d]);
        n_pieces *= n[d];
      }
    for (unsigned int i = 0; i < n_pieces; ++i)
      {
        double     content = volume;
        Point<dim> unit;
        for (unsigned int d = 0, rest = i; d < dim; rest /= n[d], ++d)
          {
            unit[d] = along[d][rest % n[d]].middle;
            content *= along[d][rest % n[d]].share;
          }
        add_at(cell, unit, content, sums);
      }
  }

  template <int dim>
  void
  PointBoxes<dim>::add_at(const unsigned int               cell,
                          const Point<dim>                &unit,
                          const double                     content,
                          typename Occupancy<dim>::Vector &sums) const
  {
    const auto        &locator = occupancy.locator;
    const Point<dim>   place   = locator.cells.geometry(cell).to_real(unit);
    const unsigned int holder  = find_touching(cell, unit);
    Point<dim>         inside =
      locator.cells.geometry(holder).to_unit(locator.image(place, holder));
    for (unsigned int d = 0; d < dim; ++d)
      inside[d] = std::clamp(inside[d], 0., 1.);
    PointBatch<dim, 1, double> point;
    point.reinit_values(inside);
    for (double &value : point.N)
      value *= content;
    occupancy.add_vertex_values(holder, point.N, sums);
  }

  template <int dim>
  void
  PointBoxes<dim>::add_part(const unsigned int               cell,
                            const std::array<Part, dim>     &part,
                            const double                     edge,
                            const double                     volume,
                            Integrals                       &integrals,
                            typename Occupancy<dim>::Vector &sums) const
  {
    unsigned int side = 0;
    for (unsigned int d = dim; d-- > 0;)
      side = 3 * side + part[d].side;
    if (!integrals.exists[side])
      {
        integrals.exists[side] = true;
        integrals.holder[side] = find_holder(cell, side);
        integrals.of_vertices[side].fill(0.);
      }
    const unsigned int holder = integrals.holder[side];
    if (holder == CellLocator<dim>::invalid)
      {
        add_elsewhere(cell, part, edge, volume, sums);
        return;
      }
    double hats[dim][2];
    for (unsigned int d = 0; d < dim; ++d)
      for (const unsigned int end : {0, 1})
        hats[d][end] = part[d].hats[end];
    if (holder == cell) // what is beyond its faces counts at them
      for (unsigned int d = 0; d < dim; ++d)
        if (part[d].side != 1)
          {
            const unsigned int end = part[d].side / 2;
            hats[d][end]           = hats[d][0] + hats[d][1];
            hats[d][1 - end]       = 0.;
          }
    for (unsigned int v = 0; v < (1u << dim); ++v)
      {
        double content = volume;
        for (unsigned int d = 0; d < dim; ++d)
          content *= hats[d][(v >> d) & 1u];
        integrals.of_vertices[side][v] += content;
      }
  }

  template <int dim>
  void
  PointBoxes<dim>::add(const PointCloud<dim>           &points,
                       const double                    *volume,
                       const unsigned int               cell,
                       typename Occupancy<dim>::Vector &sums) const
  {
    const auto            &geometry = occupancy.locator.cells.geometry(cell);
    constexpr unsigned int here     = n_sides / 2;
    PointBatch<dim, 1, double> point;
    Integrals                  integrals;
    integrals.exists[here] = true;
    integrals.holder[here] = cell;
    auto &of_vertices      = integrals.of_vertices[here];
    of_vertices.fill(0.);
    double ratio = 0., edge = 0.;
    for (const std::size_t p : points.points_in(cell))
      {
        const Point<dim> unit = geometry.to_unit(points.position(p));
        if (const double now = volume[p] / geometry.measure; now != ratio)
          {
            ratio = now; // mostly that of the point before
            edge = std::min(1., dim == 2 ? std::sqrt(ratio) : std::cbrt(ratio));
          }
        bool is_inside = true; // the mean of a hat is its value at the centre
        for (unsigned int d = 0; d < dim; ++d)
          is_inside =
            is_inside && std::abs(unit[d] - 0.5) <= 0.5 * (1. - edge) + touches;
        if (is_inside)
          {
            point.reinit_values(unit);
            for (unsigned int v = 0; v < point.n_nodes; ++v)
              of_vertices[v] += point.N[v] * volume[p];
            continue;
          }
        Part         along[dim][2];
        unsigned int n[dim], n_parts = 1;
        for (unsigned int d = 0; d < dim; ++d)
          {
            n[d] = divide(cell, d, unit[d], edge, along[d]);
            n_parts *= n[d];
          }
        std::array<Part, dim> part;
        for (unsigned int i = 0; i < n_parts; ++i)
          {
            for (unsigned int d = 0, rest = i; d < dim; rest >>= n[d] - 1, ++d)
              part[d] = along[d][n[d] == 2 ? rest & 1u : 0];
            add_part(cell, part, edge, volume[p], integrals, sums);
          }
      }
    for (unsigned int side = 0; side < n_sides; ++side)
      if (integrals.exists[side] &&
          integrals.holder[side] != CellLocator<dim>::invalid)
        occupancy.add_vertex_values(integrals.holder[side],
                                    integrals.of_vertices[side].data(),
                                    sums);
  }

  template class PointBoxes<2>;
  template class PointBoxes<3>;
} // namespace seiche
