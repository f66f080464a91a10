// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of an accepted step that would crush their volume or move too far go
// only a part of their way; the others go all of it.
#include <seiche/transfer/held_points.h>

#include <iostream>
#include <limits>
#include <string>

using namespace seiche;

namespace
{
  /// u = H x at x = 1 in every direction [cells].
  template <int dim>
  void
  test(const std::string            &name,
       const dealii::Tensor<2, dim> &H,
       const double                  way,
       const HeldPoints<dim>        &held)
  {
    double F[dim][dim][n_lanes], u[dim][n_lanes];
    for (unsigned int l = 0; l < n_lanes; ++l)
      for (unsigned int c = 0; c < dim; ++c)
        {
          u[c][l] = way;
          for (unsigned int d = 0; d < dim; ++d)
            F[c][d][l] = H[c][d] + (c == d ? 1. : 0.);
        }
    dealii::Tensor<1, dim> reach;
    for (unsigned int d = 0; d < dim; ++d)
      reach[d] = 0.5;
    const unsigned int     n_filled = 3;
    const unsigned int     n = held.shorten(F, u, reach, n_filled);
    dealii::Tensor<2, dim> after, rest;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        {
          after[c][d] = F[c][d][n_filled - 1];
          rest[c][d]  = F[c][d][n_filled] - (c == d ? 1. : 0.);
        }
    std::cout << dim << "D " << name << ": held " << n << " of " << n_filled
              << ", det F " << dealii::determinant(after) << ", way "
              << u[0][n_filled - 1] / reach[0] << " cells, lanes without point "
              << ((rest - H).norm() == 0. && u[0][n_filled] == way ?
                    "untouched" :
                    "CHANGED")
              << '\n';
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
    test("gentle", gentle, 0.1, held);
    test("squeezed", squeezed, 0.1, held);
    test("turned by 180 degrees", turned, 0.1, held);
    test("too far", gentle, 0.9, held);
    test("much too far", gentle, 100., held);
    std::cout << "factor 0.01 of the volume: " << held.bounded(0.01) << ", "
              << HeldPoints<dim>(std::numeric_limits<double>::infinity())
                   .bounded(0.01)
              << '\n';
  }
} // namespace

int
main()
{
  test<2>();
  test<3>();
}
