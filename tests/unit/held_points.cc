// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of an accepted step that would crush their volume, move too far or
// pass a wall go only a part of their way; the others go all of it.
#include <seiche/transfer/held_points.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

#include "verdict.h"

using namespace seiche;

namespace
{
  /// A wall at x = 0, below it the wall's inside.
  struct WallOnTheLeft
  {
    double
    way_beyond(const unsigned int d, const double x) const
    {
      return d == 0 ? std::max(0., -x) : 0.;
    }
  };

  /// All lanes but the last are points at @p x [m] that are to move by @p u [m].
  template <int dim>
  void
  test(const std::string            &name,
       const HeldPoints<dim>        &held,
       const dealii::Tensor<2, dim> &H,
       const dealii::Point<dim>     &x,
       const dealii::Tensor<1, dim> &u)
  {
    constexpr unsigned int        last = n_lanes_of_register - 1;
    dealii::Point<dim, Lanes>     places;
    dealii::Tensor<2, dim, Lanes> H_lanes;
    dealii::Tensor<1, dim, Lanes> u_lanes;
    dealii::Tensor<1, dim>        reach;
    for (unsigned int c = 0; c < dim; ++c)
      {
        reach[c]   = 0.5;
        places[c]  = x[c];
        u_lanes[c] = u[c];
        for (unsigned int d = 0; d < dim; ++d)
          H_lanes[c][d] = H[c][d];
      }
    const HeldFlags is_held =
      held.shorten(reach, WallOnTheLeft(), places, last, H_lanes, u_lanes);
    // the share of the way that each point goes, and H that belongs to it
    unsigned int main_axis = 0;
    for (unsigned int c = 1; c < dim; ++c)
      if (std::abs(u[c]) > std::abs(u[main_axis]))
        main_axis = c;
    const double share = u_lanes[main_axis][0] / u[main_axis];
    bool         right = true;
    for (unsigned int l = 0; l <= last; ++l)
      {
        const double part = l < last ? share : 1.;
        right &= is_held[l] == (part < 1.);
        for (unsigned int c = 0; c < dim; ++c)
          {
            right &= u_lanes[c][l] == part * u[c];
            for (unsigned int d = 0; d < dim; ++d)
              right &= H_lanes[c][d][l] == part * H[c][d];
          }
      }
    std::cout << dim << "D " << name << ": goes " << share
              << " of its way, H too, and the others of the batch: "
              << verdict(right) << '\n';
  }

  template <int dim>
  void
  test()
  {
    const HeldPoints<dim>  held(/*largest_way=*/0.9);
    dealii::Tensor<2, dim> gentle, squeezed, turned;
    gentle[0][0]   = -0.5;
    squeezed[0][0] = -1.5;
    turned[0][0] = turned[1][1] = -2.; // det F = 1, but 0 half-way
    dealii::Point<dim>     x, on_wall;
    dealii::Tensor<1, dim> near, far, left, along;
    for (unsigned int d = 0; d < dim; ++d)
      {
        x[d]    = 0.125;
        near[d] = 0.0625;
      }
    on_wall[1] = 0.125;
    far[0]     = 50.;
    left[0]    = -0.25;
    along[1]   = 0.25;
    test("gentle", held, gentle, x, near);
    test("squeezed", held, squeezed, x, near);
    test("turned by 180 degrees", held, turned, x, near);
    test("too far", held, gentle, x, 8. * near);
    test("far too far", held, gentle, x, far);
    test("through a wall", held, gentle, x, left);
    test("along a wall", held, gentle, on_wall, along);
    const HeldPoints<dim> none(std::numeric_limits<double>::infinity());
    std::cout << dim << "D volume ratios within 0.75 and 1.25: "
              << verdict(held.bounded(0.1) == 0.75 &&
                         held.bounded(0.9) == 0.9 && held.bounded(3.) == 1.25)
              << ", without a limit none is held: "
              << verdict(held.any_may_be() && !none.any_may_be()) << '\n';
  }
} // namespace

int
main()
{
  test<2>();
  test<3>();
}
