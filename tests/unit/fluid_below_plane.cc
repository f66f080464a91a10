// SPDX-License-Identifier: LGPL-2.1-or-later
// Films on a bed that slopes through the cells above a node: the level of the
// surface from the fluid in the node's hat, at any depth.
#include <seiche/grid/fluid_below_plane.h>
#include <seiche/space/wet_part.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
  using namespace dealii;
  using namespace seiche;

  /// The node is the middle of the cells' floor; the bed is 0.4 cells above it.
  template <int dim>
  double
  level_of_film(const double depth, const double most, const double guess)
  {
    using Shape = GeometryInfo<dim>;
    Tensor<1, dim> gradient, bed;
    gradient[dim - 1] = 1.;
    bed[dim - 1]      = 1.;
    bed[0]            = 0.05; // gentle
    VertexValues<dim> everywhere;
    everywhere.fill(-1.);
    double fluid = 0.;
    for (const bool is_filled : {false, true})
      {
        FluidBelowPlane<dim> result(fluid);
        for (unsigned int vertex = 0; vertex < (1u << (dim - 1)); ++vertex)
          {
            VertexValues<dim> phi, wall;
            for (const unsigned int v : Shape::vertex_indices())
              {
                const Tensor<1, dim> way =
                  Shape::unit_cell_vertex(v) - Shape::unit_cell_vertex(vertex);
                wall[v] = bed * way - 0.4;
                phi[v]  = gradient * way - 0.4 - depth;
              }
            if (is_filled)
              result.add_cell(vertex,
                              0.1,
                              hat_integrals<dim>(everywhere, wall)[vertex],
                              wall);
            else
              fluid += 0.1 * hat_integrals<dim>(phi, wall)[vertex];
          }
        if (is_filled)
          return result.level(gradient, most, guess);
      }
    return 0.;
  }

  template <int dim>
  void
  test()
  {
    double error = 0.;
    for (const double depth : {0.01, 0.05, 0.2, 0.55})
      for (const double guess : {-1., -0.4 - depth, 0., 1.})
        error = std::max(error,
                         std::abs(level_of_film<dim>(depth, 0.5, guess) + 0.4 +
                                  depth));
    std::cout << dim << "D, films: " << (error < 1e-4 ? "right" : "WRONG")
              << ", dry: " << level_of_film<dim>(-0.2, 0.5, 0.)
              << ", no more than the neighbours say: "
              << level_of_film<dim>(0.2, -0.7, 0.) << '\n';
  }
} // namespace

int
main()
{
  test<2>();
  test<3>();
}
