// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/polygon_shape.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>

namespace seiche
{
  namespace
  {
    template <int dim>
    using Box = dealii::BoundingBox<dim>;



    using Vertex  = boost::geometry::model::d2::point_xy<double>;
    using Polygon = boost::geometry::model::polygon<Vertex>;



    /// In 3D a prism along y with vertices x z.
    template <int dim>
    class PolygonShape : public Shape<dim>
    {
    public:
      /// @p along_y: from and to in 3D; without bounds the prism is endless
      /// and @p domain bounds it.
      PolygonShape(const Polygon                              &outline,
                   const std::optional<std::array<double, 2>> &along_y,
                   const Box<dim>                             &domain)
        : polygon(outline)
        , edges(outline.outer().begin(), outline.outer().end())
        , span(along_y)
        , box(find_box(domain))
      {}

      /// At the ends of a prism the larger of the distances: less than the
      /// distance off its edges.
      double
      distance(const dealii::Point<dim> &x) const override
      {
        const Vertex place(x[0], x[dim - 1]);
        double       result = boost::geometry::distance(place, edges);
        if (boost::geometry::within(place, polygon))
          result = -result;
        if (span)
          result = std::max({result, (*span)[0] - x[1], x[1] - (*span)[1]});
        return result;
      }

      double
      volume() const override
      {
        const double area = boost::geometry::area(polygon);
        return dim == 2 ? area : area * box.side_length(1);
      }

      bool
      is_endless() const override
      {
        return dim == 3 && !span;
      }

      Box<dim>
      bounding_box() const override
      {
        return box;
      }

    private:
      Box<dim>
      find_box(const Box<dim> &domain) const
      {
        auto        corners = domain.get_boundary_points();
        auto       &lower   = corners.first;
        auto       &upper   = corners.second;
        const auto &first   = edges.front();
        lower[0] = upper[0] = first.x();
        lower[dim - 1] = upper[dim - 1] = first.y();
        for (const Vertex &vertex : edges)
          {
            lower[0]       = std::min(lower[0], vertex.x());
            upper[0]       = std::max(upper[0], vertex.x());
            lower[dim - 1] = std::min(lower[dim - 1], vertex.y());
            upper[dim - 1] = std::max(upper[dim - 1], vertex.y());
          }
        if (span)
          {
            lower[1] = (*span)[0];
            upper[1] = (*span)[1];
          }
        return Box<dim>(corners);
      }

      const Polygon                                    polygon;
      const boost::geometry::model::linestring<Vertex> edges;
      const std::optional<std::array<double, 2>>       span;
      const Box<dim>                                   box;
    };



    /// Twice the signed area of the triangle a, b, c.
    double
    signed_area(const Vertex &a, const Vertex &b, const Vertex &c)
    {
      return (b.x() - a.x()) * (c.y() - a.y()) -
             (b.y() - a.y()) * (c.x() - a.x());
    }



    /// True if two edges of the closed ring cross in their interiors.
    bool
    crosses_itself(const std::vector<Vertex> &ring)
    {
      for (std::size_t i = 0; i + 1 < ring.size(); ++i)
        for (std::size_t j = i + 2; j + 1 < ring.size(); ++j)
          if (signed_area(ring[i], ring[i + 1], ring[j]) *
                  signed_area(ring[i], ring[i + 1], ring[j + 1]) <
                0. &&
              signed_area(ring[j], ring[j + 1], ring[i]) *
                  signed_area(ring[j], ring[j + 1], ring[i + 1]) <
                0.)
            return true;
      return false;
    }



    /// Closed, with the orientation that Boost.Geometry wants.
    Polygon
    closed_polygon(const PolygonVertices &vertices)
    {
      Polygon polygon;
      for (const auto &vertex : vertices)
        polygon.outer().emplace_back(vertex[0], vertex[1]);
      boost::geometry::correct(polygon);
      return polygon;
    }
  } // namespace



  std::string
  problem_of_polygon(const PolygonVertices &vertices)
  {
    const Polygon polygon = closed_polygon(vertices);
    if (crosses_itself(polygon.outer()))
      return "the edges cross each other; give the vertices in order.";
    if (!(boost::geometry::area(polygon) > 0.))
      return "the polygon has no area.";
    return "";
  }



  template <int dim>
  ShapePointer<dim>
  polygon_shape(const PolygonVertices                      &vertices,
                const std::optional<std::array<double, 2>> &span,
                const Box<dim>                             &domain)
  {
    return std::make_unique<PolygonShape<dim>>(closed_polygon(vertices),
                                               span,
                                               domain);
  }



#define INSTANTIATE(dim)                          \
  template ShapePointer<dim> polygon_shape<dim>(  \
    const PolygonVertices &,                      \
    const std::optional<std::array<double, 2>> &, \
    const Box<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
