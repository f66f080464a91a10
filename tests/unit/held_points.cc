// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of an accepted step that would crush their volume, move too far or
// pass a wall go only a part of their way; the others go all of it.
#include <seiche/transfer/held_points.h>

#include <iostream>
#include <limits>
#include <string>

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
    dealii::Tensor<2, dim> after;
    dealii::Tensor<1, dim> moved;
    bool                   lanes_agree = true;
    for (unsigned int c = 0; c < dim; ++c)
      {
        moved[c] = u_lanes[c][0];
        lanes_agree &=
          u_lanes[c][last - 1] == moved[c] && u_lanes[c][last] == u[c];
        for (unsigned int d = 0; d < dim; ++d)
          after[c][d] = H_lanes[c][d][0] + (c == d ? 1. : 0.);
      }
    std::cout << dim << "D " << name << ": " << (is_held[0] ? "held" : "free")
              << ", det F " << dealii::determinant(after) << ", to "
              << x + moved << (lanes_agree ? "" : ", LANES DIFFER") << '\n';
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
    std::cout
      << "volume ratios 0.1, 0.9 and 3: " << held.bounded(0.1) << ", "
      << held.bounded(0.9) << ", " << held.bounded(3.)
      << "; some may be held: " << held.any_may_be() << ", "
      << HeldPoints<dim>(std::numeric_limits<double>::infinity()).any_may_be()
      << '\n';
  }
} // namespace

int
main()
{
  test<2>();
  test<3>();
}
