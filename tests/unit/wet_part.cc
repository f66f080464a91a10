// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells that a wall and a free surface cut: over a grid, volumes and walls are
// those of a disc or ball; the divergence theorem of p w holds for hats w and p
// linear, zero on the surface, wherever the wall lies: water at rest stays at
// rest.
#include <seiche/space/surface_pieces.h>
#include <seiche/space/wet_part.h>

#include <deal.II/base/geometry_info.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <map>

namespace
{
  using namespace dealii;
  using namespace seiche;

  template <int dim>
  using Function = std::function<double(const Point<dim> &)>;

  template <int dim>
  struct Sums
  {
    double         volume = 0., wall = 0., defect = 0.;
    unsigned int   most_points = 0;
    double         least       = 1.; // weight
    Tensor<1, dim> closed;
  };

  /// Of the fluid with level < 0 and distance > 0 in [-1, 1]^dim.
  template <int dim>
  Sums<dim>
  sums(const Function<dim> &level,
       const Function<dim> &distance,
       const unsigned int   n)
  {
    Sums<dim>      result;
    const double   h = 2. / n;
    Tensor<1, dim> gradient; // of the level, the pressure
    for (unsigned int d = 0; d < dim; ++d)
      {
        Point<dim> x;
        x[d]        = 1.;
        gradient[d] = level(x) - level(Point<dim>());
      }
    std::map<std::array<int, dim>, Tensor<1, dim>> at_nodes;
    const unsigned int n_cells = std::pow(n, dim) + 0.5;
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        std::array<int, dim> index;
        Point<dim>           lower, upper;
        for (unsigned int d = 0, rest = i; d < dim; ++d, rest /= n)
          {
            index[d] = rest % n;
            lower[d] = -1. + index[d] * h;
            upper[d] = lower[d] + h;
          }
        const CellGeometry<dim> geometry(lower, upper);
        VertexValues<dim>       phi, psi;
        for (unsigned int v = 0; v < phi.size(); ++v)
          {
            const auto x =
              geometry.to_real(GeometryInfo<dim>::unit_cell_vertex(v));
            phi[v] = level(x);
            psi[v] = distance(x);
          }
        const WetPart<dim> part(phi, psi, geometry);
        result.volume += part.volume * geometry.measure;
        result.most_points =
          std::max<unsigned int>(result.most_points, part.points.size());
        const auto add = [&](const Point<dim> &unit, const auto &integrand) {
          for (unsigned int v = 0; v < phi.size(); ++v)
            {
              std::array<int, dim> node = index;
              for (unsigned int d = 0; d < dim; ++d)
                node[d] += (v >> d) & 1u;
              Tensor<1, dim> grad =
                GeometryInfo<dim>::d_linear_shape_function_gradient(unit, v);
              at_nodes[node] +=
                integrand(GeometryInfo<dim>::d_linear_shape_function(unit, v),
                          grad / h,
                          level(geometry.to_real(unit)));
            }
        };
        for (const auto &point : part.points)
          {
            result.least = std::min(result.least, point.weight);
            add(point.unit,
                [&](const double          N,
                    const Tensor<1, dim> &grad,
                    const double          p) {
                  return point.weight * geometry.measure *
                         (p * grad + N * gradient);
                });
          }
        for (const auto &point : part.wall)
          {
            result.wall += point.area.norm();
            result.closed += point.area;
            add(point.unit,
                [&](const double N, const Tensor<1, dim> &, const double p) {
                  return -p * N * point.area;
                });
          }
      }
    for (const auto &[node, sum] : at_nodes)
      if (std::all_of(node.begin(), node.end(), [&](const int k) {
            return k > 0 && k < static_cast<int>(n);
          }))
        result.defect = std::max(result.defect, sum.norm());
    return result;
  }

  /// A box whose faces lie on grid lines.
  template <int dim>
  void
  check_along_lines()
  {
    const Function<dim> inside = [](const Point<dim> &x) {
      double result = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        result = std::min(result, 0.5 - std::abs(x[d]));
      return result;
    };
    const Function<dim> full = [](const Point<dim> &x) { return x[0] - 5.; };
    const Sums<dim>     box  = sums<dim>(full, inside, 8);
    std::cout << dim << "D box along the grid: volume " << box.volume
              << ", wall " << box.wall << ", closed "
              << (box.closed.norm() < 1e-12) << ", divergence theorem "
              << (box.defect < 1e-12) << std::endl;
  }

  /// Where the surface meets a wall at a vertex of the cell's simplices, pieces
  /// may shrink to nothing: they have no normal.
  template <int dim>
  void
  check_through_centre()
  {
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = 1.;
    VertexValues<dim> level, wall;
    for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
      {
        const Point<dim> x = GeometryInfo<dim>::unit_cell_vertex(v);
        level[v]           = x[dim - 1] - 0.5;
        wall[v]            = x[0] - 0.5;
      }
    const WetPart<dim> part(level, wall, CellGeometry<dim>(lower, upper));
    double             least = 1., area = 0.;
    for (const WallPoint<dim> &point : part.wall)
      {
        least = std::min(least, point.area.norm());
        area += point.area.norm();
      }
    std::cout << dim << "D, both through the centre: volume " << part.volume
              << ", wall " << area << ", all of it has an area " << (least > 0.)
              << std::endl;
  }

  template <int dim>
  void
  check(const unsigned int n)
  {
    Point<dim> centre;
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = 0.03 * d - 0.02;
    const double        r      = 0.77;
    const Function<dim> inside = [&](const Point<dim> &x) {
      return r - x.distance(centre);
    };
    const Function<dim> full  = [](const Point<dim> &x) { return x[0] - 5.; };
    const Function<dim> level = [](const Point<dim> &x) {
      return x[dim - 1] - 0.21 * x[0] - 0.137;
    };
    const auto   whole  = sums<dim>(full, inside, n);
    const auto   part   = sums<dim>(level, inside, n);
    const double pi     = numbers::PI;
    const double volume = dim == 2 ? pi * r * r : 4. / 3. * pi * r * r * r,
                 wall   = dim == 2 ? 2. * pi * r : 4. * pi * r * r;
    std::cout << dim << "D: volume " << whole.volume / volume - 1. << ", wall "
              << whole.wall / wall - 1. << ", closed "
              << (whole.closed.norm() < 1e-12) << ", divergence theorem "
              << (whole.defect < 1e-12) << " " << (part.defect < 1e-13)
              << ", points of a cell " << part.most_points
              << ", weights positive " << (part.least > 0.) << std::endl;
  }
} // namespace

int
main()
{
  std::cout.precision(3);
  check<2>(16);
  check<3>(12);
  check_along_lines<2>();
  check_along_lines<3>();
  check_through_centre<2>();
  check_through_centre<3>();
}
