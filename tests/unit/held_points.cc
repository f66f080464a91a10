// SPDX-License-Identifier: LGPL-2.1-or-later
// Points of an accepted step that would crush their volume, move too far or
// pass a wall go only a part of their way; the others go all of it.
#include <seiche/transfer/held_points.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <limits>
#include <string>

#include "scene_from_text.h"

using namespace seiche;

namespace
{
  template <int dim>
  std::string
  grid_text()
  {
    const std::string z = dim == 3 ? ", 0" : "", one = dim == 3 ? ", 1" : "";
    return "subsection Grid\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 1, 1" + one +
           "\n set Cell size = 0.5\nend\n"
           "subsection Walls\n set Top = open\nend\n"
           "subsection Fluid body a\n set Lower corner = 0, 0" +
           z + "\n set Upper corner = 1, 1" + one + "\nend\n";
  }

  /// Three points at @p x [m] that are to move by @p u [m].
  template <int dim>
  void
  test(const std::string            &name,
       const HeldPoints<dim>        &held,
       const dealii::Tensor<2, dim> &H,
       const dealii::Point<dim>     &x,
       const dealii::Tensor<1, dim> &u)
  {
    const unsigned int              n_filled = 3;
    double                          places[dim][n_lanes];
    double                          F[dim][dim][n_lanes], way[dim][n_lanes];
    bool                            is_held[n_lanes] = {};
    std::array<const double *, dim> place;
    for (unsigned int c = 0; c < dim; ++c)
      {
        place[c] = places[c];
        for (unsigned int l = 0; l < n_lanes; ++l)
          {
            places[c][l] = x[c];
            way[c][l]    = u[c];
            for (unsigned int d = 0; d < dim; ++d)
              F[c][d][l] = H[c][d] + (c == d ? 1. : 0.);
          }
      }
    held.shorten(/*cell=*/0, place, n_filled, F, way, is_held);
    dealii::Tensor<2, dim> after;
    dealii::Tensor<1, dim> moved;
    bool                   lanes_agree = true;
    for (unsigned int c = 0; c < dim; ++c)
      {
        moved[c] = way[c][n_filled - 1];
        lanes_agree &= way[c][0] == moved[c] && way[c][n_filled] == u[c];
        for (unsigned int d = 0; d < dim; ++d)
          after[c][d] = F[c][d][n_filled - 1];
      }
    std::cout << dim << "D " << name << ": " << (is_held[0] ? "held" : "free")
              << ", det F " << dealii::determinant(after) << ", to "
              << x + moved << (lanes_agree ? "" : ", LANES DIFFER") << '\n';
  }

  template <int dim>
  void
  test()
  {
    const SceneFromText<dim> scene(grid_text<dim>());
    BackgroundGrid<dim>      grid(scene.grid_parameters, MPI_COMM_WORLD);
    CellLocator<dim>         locator(grid);
    const HeldPoints<dim>    held(locator, /*largest_way=*/0.9);
    dealii::Tensor<2, dim>   gentle, squeezed, turned;
    gentle[0][0]   = -0.5;
    squeezed[0][0] = -1.5;
    turned[0][0] = turned[1][1] = -2.; // det F = 1, but 0 half-way
    dealii::Point<dim>     x;
    dealii::Tensor<1, dim> near, far, left, up;
    for (unsigned int d = 0; d < dim; ++d)
      {
        x[d]    = 0.125;
        near[d] = 0.0625;
      }
    far[0]                  = 50.;
    left[0]                 = -0.25;
    up[1]                   = 0.5;
    dealii::Point<dim> high = x;
    high[1]                 = 0.75;
    test("gentle", held, gentle, x, near);
    test("squeezed", held, squeezed, x, near);
    test("turned by 180 degrees", held, turned, x, near);
    test("far too far", held, gentle, x, far);
    test("through a wall", held, gentle, x, left);
    test("through an open side, too far", held, gentle, high, up);
    test("through an open side", held, gentle, high, 0.75 * up);
    std::cout << "volume ratios 0.1, 0.9 and 3: " << held.bounded(0.1) << ", "
              << held.bounded(0.9) << ", " << held.bounded(3.)
              << "; some may be held: " << held.any_may_be() << ", "
              << HeldPoints<dim>(locator,
                                 std::numeric_limits<double>::infinity())
                   .any_may_be()
              << '\n';
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
