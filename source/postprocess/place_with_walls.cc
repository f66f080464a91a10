// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/place_with_walls.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Point<dim>
  place_with_walls(const StepView<dim> &view,
                   const Point<dim>    &place,
                   const double         theta)
  {
    const auto      &locator = view.occupancy.locator;
    const auto      &grid    = locator.grid.parameters;
    const Point<dim> begin   = grid.with_sides(place, locator.lines.domain());
    return begin + theta * (grid.with_sides(place, view.box) - begin);
  }

  template Point<2>
  place_with_walls(const StepView<2> &, const Point<2> &, const double);
  template Point<3>
  place_with_walls(const StepView<3> &, const Point<3> &, const double);
} // namespace seiche
