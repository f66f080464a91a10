// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/point_shift.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  PointShift<dim>::PointShift(const unsigned int      own_cell,
                              PointCloud<dim>        &cloud,
                              const BoundingBox<dim> &box)
    : cell(own_cell)
    , points(cloud)
    , domain(box)
  {
    for (unsigned int face = 0; face < 2 * dim; ++face)
      is_wall[face] = points.locator.cells.wall_at(cell, face);
    const bool has_gradient = points.has(PointColumn::velocity_gradient);
    for (unsigned int c = 0; c < dim; ++c)
      {
        position[c] = points.data(PointColumn::position, c);
        velocity[c] = points.data(PointColumn::velocity, c);
        for (unsigned int d = 0; d < dim; ++d)
          gradient[c * dim + d] =
            has_gradient ?
              points.data(PointColumn::velocity_gradient, c * dim + d) :
              nullptr;
      }
  }

  template <int dim>
  void
  PointShift<dim>::apply(const std::size_t point,
                         Tensor<1, dim>    delta,
                         const double      velocity_share) const
  {
    const auto           &locator = points.locator;
    const Tensor<1, dim> &extent  = locator.cells.geometry(cell).edges;
    const Point<dim>     &lower   = locator.cells.geometry(cell).lower;
    Point<dim>            place;
    for (unsigned int d = 0; d < dim; ++d)
      {
        place[d]            = position[d][point];
        const bool   up     = delta[d] > 0.;
        const double length = std::abs(delta[d]);
        if (length > 0. && is_wall[BoxFace(d, up)])
          {
            double distance =
              up ? lower[d] + extent[d] - place[d] : place[d] - lower[d];
            distance = std::min(distance,
                                up ? domain.upper_bound(d) - place[d] :
                                     place[d] - domain.lower_bound(d));
            distance = std::max(0., distance / extent[d]);
            delta[d] *= distance / (distance + length);
          }
        delta[d] *= extent[d];
        place[d] += delta[d];
      }
    if (!locator.cells.geometry(cell).holds(place))
      {
        // no farther than every rank that has the cell can see
        for (unsigned int d = 0; d < dim; ++d)
          if (std::abs(place[d] - lower[d] - 0.5 * extent[d]) >
              0.5 * extent[d] + locator.cells.reach(cell)[d])
            return;
        if (locator.find(place, cell) == CellLocator<dim>::invalid)
          return;
      }
    for (unsigned int c = 0; c < dim; ++c)
      {
        position[c][point] = place[c];
        if (gradient[c] != nullptr)
          for (unsigned int d = 0; d < dim; ++d)
            velocity[c][point] +=
              velocity_share * delta[d] * gradient[c * dim + d][point];
      }
  }

  template class PointShift<2>;
  template class PointShift<3>;
} // namespace seiche
