// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/shift_point.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  shift_point(const unsigned int cell,
              const std::size_t  point,
              Tensor<1, dim>     delta,
              PointCloud<dim>   &points)
  {
    const auto      &locator = points.locator;
    Point<dim>       place   = points.position(point);
    const Point<dim> unit    = locator.to_unit(cell, place);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const bool   up     = delta[d] > 0.;
        const double length = std::abs(delta[d]);
        if (length > 0. && locator.boundary_id(cell, 2 * d + up) !=
                             numbers::internal_face_boundary_id)
          {
            const double distance = std::max(0., up ? 1. - unit[d] : unit[d]);
            delta[d] *= distance / (distance + length);
          }
        delta[d] *= locator.extent(cell)[d];
        place[d] += delta[d];
      }
    if (!locator.holds(cell, place) &&
        locator.find(place, cell) == CellLocator<dim>::invalid)
      return;
    for (unsigned int c = 0; c < dim; ++c)
      {
        points.data(PointColumn::position, c)[point] = place[c];
        double &velocity = points.data(PointColumn::velocity, c)[point];
        if (points.has(PointColumn::velocity_gradient))
          for (unsigned int d = 0; d < dim; ++d)
            velocity += delta[d] * points.data(PointColumn::velocity_gradient,
                                               c * dim + d)[point];
      }
  }

  template void
  shift_point(const unsigned int,
              const std::size_t,
              Tensor<1, 2>,
              PointCloud<2> &);
  template void
  shift_point(const unsigned int,
              const std::size_t,
              Tensor<1, 3>,
              PointCloud<3> &);
} // namespace seiche
