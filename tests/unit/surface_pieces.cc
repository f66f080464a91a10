// SPDX-License-Identifier: LGPL-2.1-or-later
// Pieces of a level set's zero: their area, that they close around the inside
// of CutCell, and where normals point.
#include <seiche/space/cut_cell.h>
#include <seiche/space/surface_pieces.h>

#include <cmath>
#include <functional>
#include <iomanip>
#include <iostream>

using namespace dealii;
using namespace seiche;

namespace
{
  struct Sums
  {
    double area     = 0.;
    double enclosed = 0.; ///< int x.n/dim dA
    double inside   = 0.; ///< volume of CutCell
    double open     = 0.; ///< |int n dA|
  };

  /// Over the unit cube, n cells a direction.
  template <int dim>
  Sums
  integrate(const std::function<double(const Point<dim> &)> &level,
            const unsigned int                               n)
  {
    Sums           sums;
    Tensor<1, dim> total;
    const double   h = 1. / n;
    for (unsigned int cell = 0; cell < std::pow(n, dim); ++cell)
      {
        Point<dim>   corner;
        unsigned int rest = cell;
        for (unsigned int d = 0; d < dim; ++d, rest /= n)
          corner[d] = rest % n * h;
        VertexValues<dim> values;
        for (unsigned int v = 0; v < values.size(); ++v)
          values[v] =
            level(corner + h * GeometryInfo<dim>::unit_cell_vertex(v));
        sums.inside += std::pow(h, dim) * CutCell<dim>(values).volume();
        for (SurfacePiece<dim> piece : surface_pieces<dim>(values))
          {
            Tensor<1, dim> mean;
            for (Point<dim> &x : piece)
              {
                x = corner + h * x;
                mean += (x - Point<dim>()) / dim;
              }
            const Tensor<1, dim> area = area_vector<dim>(piece);
            sums.area += area.norm();
            sums.enclosed += area * mean / dim;
            total += area;
          }
      }
    sums.open = total.norm();
    return sums;
  }

  template <int dim>
  void
  check()
  {
    // flat, anywhere between two grid lines or on one
    double flat = 0., tilted = 0.;
    for (const double height : {0.5, 0.53, 0.5625, 0.6249, 0.625})
      {
        const Sums level = integrate<dim>(
          [height](const Point<dim> &x) {
            const double value = x[dim - 1] - height;
            return value == 0. ? 1e-12 : value;
          },
          8);
        flat             = std::max(flat, std::abs(level.area - 1.));
        const Sums slope = integrate<dim>(
          [height](const Point<dim> &x) {
            return x[dim - 1] - height - 0.3 * (x[0] - 0.5);
          },
          8);
        tilted = std::max(tilted, std::abs(slope.area / std::sqrt(1.09) - 1.));
      }
    std::cout << dim << "D, area of planes: "
              << (flat < 1e-10 && tilted < 1e-12 ? "yes" : "NO") << '\n';

    // a ball; its inside is what its surface encloses, normals point out
    const double radius = 0.36;
    const double area =
      dim == 2 ? 2. * numbers::PI * radius : 4. * numbers::PI * radius * radius;
    double before = 0.;
    for (const unsigned int n : {8, 16, 32})
      {
        const Sums ball = integrate<dim>(
          [radius](const Point<dim> &x) {
            Point<dim> centre;
            for (unsigned int d = 0; d < dim; ++d)
              centre[d] = 0.5 + 0.01 * (d + 1);
            return x.distance(centre) - radius;
          },
          n);
        const double error = ball.area / area - 1.;
        std::cout << dim << "D, area of a ball, " << n << " cells: error "
                  << error;
        if (before != 0.)
          std::cout << ", order " << std::log2(before / error);
        std::cout << "; closed: " << (ball.open < 1e-12 ? "yes" : "NO")
                  << "; encloses the inside: "
                  << (std::abs(ball.enclosed - ball.inside) < 1e-12 ? "yes" :
                                                                      "NO")
                  << '\n';
        before = error;
      }

    VertexValues<dim> positive, negative;
    positive.fill(1.);
    negative.fill(-1.);
    std::cout << dim << "D, none in a cell that is not cut: "
              << (surface_pieces<dim>(positive).empty() &&
                      surface_pieces<dim>(negative).empty() ?
                    "yes" :
                    "NO")
              << '\n';
  }
} // namespace

int
main()
{
  std::cout << std::setprecision(6);
  check<2>();
  check<3>();
}
