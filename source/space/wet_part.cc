// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/compressed_rule.h>
#include <seiche/space/divided_simplex.h>
#include <seiche/space/surface_pieces.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A function that is linear on a simplex, wherever it is asked for.
    template <int dim>
    class LinearFunction
    {
    public:
      explicit LinearFunction(const CellSimplex<dim> &simplex)
        : origin(simplex.vertices[0])
        , value(simplex.values[0])
      {
        Tensor<2, dim> edges;
        Tensor<1, dim> differences;
        for (unsigned int i = 0; i < dim; ++i)
          {
            edges[i]       = simplex.vertices[i + 1] - origin;
            differences[i] = simplex.values[i + 1] - value;
          }
        gradient = invert(edges) * differences;
      }

      /// A simplex with the values there.
      template <int k>
      CellSimplex<dim, k>
      on(const std::array<Point<dim>, k + 1> &vertices) const
      {
        CellSimplex<dim, k> result;
        result.vertices = vertices;
        for (unsigned int v = 0; v <= k; ++v)
          result.values[v] = value + gradient * (vertices[v] - origin);
        return result;
      }

    private:
      const Point<dim> origin;
      const double     value;
      Tensor<1, dim>   gradient;
    };

    /// action(point) on rules of degree dim with positive weights: the middles
    /// of a triangle's edges; the vertices of a tetrahedron and the centres of
    /// its faces.
    template <typename Action>
    void
    for_each_point(const std::array<Point<2>, 3> &x, const Action &action)
    {
      const double area =
        0.5 * std::abs((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) -
                       (x[2][0] - x[0][0]) * (x[1][1] - x[0][1]));
      if (area > 0.)
        for (unsigned int v = 0; v < 3; ++v)
          action(
            WeightedPoint<2>{x[v] + 0.5 * (x[(v + 1) % 3] - x[v]), area / 3.});
    }

    template <typename Action>
    void
    for_each_point(const std::array<Point<3>, 4> &x, const Action &action)
    {
      const double volume =
        std::abs(cross_product_3d(x[1] - x[0], x[2] - x[0]) * (x[3] - x[0])) /
        6.;
      if (volume > 0.)
        for (unsigned int v = 0; v < 4; ++v)
          {
            action(WeightedPoint<3>{x[v], volume / 40.});
            Point<3> opposite;
            for (unsigned int w = 0; w < 4; ++w)
              if (w != v)
                opposite += Tensor<1, 3>(x[w]) / 3.;
            action(WeightedPoint<3>{opposite, 9. * volume / 40.});
          }
    }

    template <int dim>
    void
    add_wall_points(const SurfacePiece<dim>     &piece,
                    const CellGeometry<dim>     &geometry,
                    std::vector<WallPoint<dim>> &points)
    {
      SurfacePiece<dim> real;
      for (unsigned int v = 0; v < dim; ++v)
        real[v] = geometry.to_real(piece[v]);
      const Tensor<1, dim> area = area_vector<dim>(real);
      // degree 3 on a line, 5 on a triangle
      static const QGaussSimplex<dim - 1> rule(dim);
      const double whole = dim == 2 ? 1. : 0.5; // of the unit simplex
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          Point<dim> x = piece[0];
          for (unsigned int d = 0; d + 1 < dim; ++d)
            x += rule.point(q)[d] * (piece[d + 1] - piece[0]);
          points.push_back({x, rule.weight(q) / whole * area});
        }
    }

    template <int dim>
    bool
    is_outside(const CellSimplex<dim> &simplex)
    {
      return std::all_of(simplex.values.begin(),
                         simplex.values.end(),
                         [](const double value) { return value >= 0.; });
    }

    /// action(point) on a rule for what both functions leave of one of the
    /// cell's simplices.
    template <int dim, typename Action>
    void
    for_each_point_inside(const CellSimplex<dim> &of_wall,
                          const CellSimplex<dim> &of_surface,
                          const Action           &action)
    {
      if (is_outside<dim>(of_wall) || is_outside<dim>(of_surface))
        return;
      using Vertices = typename DividedSimplex<dim>::Vertices;
      const LinearFunction<dim> level(of_surface);
      DividedSimplex<dim>(of_wall).for_each_inside([&](const Vertices &wet) {
        const auto simplex = level.template on<dim>(wet);
        DividedSimplex<dim>(simplex).for_each_inside(
          [&](const Vertices &part) { for_each_point(part, action); });
      });
    }

    /// action(point) on a rule for what both functions leave of the cell.
    template <int dim, typename Action>
    void
    for_each_point_inside(const VertexValues<dim> &surface,
                          const VertexValues<dim> &wall,
                          const Action            &action)
    {
      const auto of_surface = cell_simplices<dim>(surface),
                 of_wall    = cell_simplices<dim>(negated<dim>(wall));
      for (unsigned int s = 0; s < of_wall.size(); ++s)
        for_each_point_inside<dim>(of_wall[s], of_surface[s], action);
    }
  } // namespace

  template <int dim>
  WetPart<dim>::WetPart(const VertexValues<dim> &surface,
                        const VertexValues<dim> &wall_distance,
                        const CellGeometry<dim> &geometry)
  {
    const auto of_surface = cell_simplices<dim>(surface),
               of_wall    = cell_simplices<dim>(negated<dim>(wall_distance));

    std::vector<WeightedPoint<dim>> all;
    std::vector<SurfacePiece<dim>>  pieces;
    for (unsigned int s = 0; s < of_wall.size(); ++s)
      {
        for_each_point_inside<dim>(of_wall[s],
                                   of_surface[s],
                                   [&](const WeightedPoint<dim> &point) {
                                     all.push_back(point);
                                   });
        pieces.clear();
        add_pieces<dim>(of_wall[s], pieces);
        if (pieces.empty() || is_outside<dim>(of_surface[s]))
          continue;
        const LinearFunction<dim> level(of_surface[s]);
        for (const SurfacePiece<dim> &piece : pieces)
          {
            const auto with_level = level.template on<dim - 1>(piece);
            for (const SurfacePiece<dim> &part :
                 parts_inside<dim>(piece, with_level.values))
              add_wall_points<dim>(part, geometry, wall);
          }
      }
    for (const WeightedPoint<dim> &point : all)
      volume += point.weight;
    if (!all.empty())
      points = compressed_rule<dim>(all, dim);
  }

  template <int dim>
  VertexValues<dim>
  hat_integrals(const VertexValues<dim> &surface, const VertexValues<dim> &wall)
  {
    VertexValues<dim> result{};
    for_each_point_inside<dim>(surface,
                               wall,
                               [&](const WeightedPoint<dim> &point) {
                                 add_hats<dim>(point, result);
                               });
    return result;
  }

  template <int dim>
  double
  hat_integral(const unsigned int       vertex,
               const VertexValues<dim> &surface,
               const VertexValues<dim> &wall)
  {
    double result = 0.;
    for_each_point_inside<dim>(
      surface, wall, [&](const WeightedPoint<dim> &point) {
        result +=
          point.weight *
          GeometryInfo<dim>::d_linear_shape_function(point.unit, vertex);
      });
    return result;
  }

  template struct WetPart<2>;
  template struct WetPart<3>;
  template VertexValues<2>
  hat_integrals<2>(const VertexValues<2> &, const VertexValues<2> &);
  template VertexValues<3>
  hat_integrals<3>(const VertexValues<3> &, const VertexValues<3> &);
  template double
  hat_integral<2>(const unsigned int,
                  const VertexValues<2> &,
                  const VertexValues<2> &);
  template double
  hat_integral<3>(const unsigned int,
                  const VertexValues<3> &,
                  const VertexValues<3> &);
} // namespace seiche
