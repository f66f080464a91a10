// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/place_with_walls.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Point<dim>
  place_with_walls(const StepView<dim> &view,
                   const Point<dim>    &place,
                   const double         theta)
  {
    constexpr double slack   = 1e-9; // of the domain: on a wall
    const auto      &locator = view.occupancy.locator;
    const auto      &first   = locator.grid.parameters;
    const auto       from    = locator.domain().get_boundary_points();
    const auto       to      = view.box.get_boundary_points();
    Point<dim>       result  = place;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double length = first.upper_corner[d] - first.lower_corner[d];
        const auto   follow =
          [&](const double side, const double begin, const double end) {
            if (std::abs(place[d] - side) <= slack * length)
              result[d] = begin + theta * (end - begin);
          };
        follow(first.lower_corner[d], from.first[d], to.first[d]);
        follow(first.upper_corner[d], from.second[d], to.second[d]);
      }
    return result;
  }

  template Point<2>
  place_with_walls(const StepView<2> &, const Point<2> &, const double);
  template Point<3>
  place_with_walls(const StepView<3> &, const Point<3> &, const double);
} // namespace seiche
