// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/expression.h>
#include <seiche/scene/region.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

namespace seiche
{
  namespace
  {
    template <int dim>
    using Box = dealii::BoundingBox<dim>;



    template <int dim>
    class BoxRegion : public Region<dim>
    {
    public:
      explicit BoxRegion(const Box<dim> &extent)
        : box(extent)
      {}

      double
      level(const dealii::Point<dim> &x) const override
      {
        double result = std::numeric_limits<double>::lowest();
        for (unsigned int d = 0; d < dim; ++d)
          result = std::max(
            {result, box.lower_bound(d) - x[d], x[d] - box.upper_bound(d)});
        return result;
      }

      bool
      is_box() const override
      {
        return true;
      }

      double
      volume() const override
      {
        return box.volume();
      }

      Box<dim>
      bounding_box() const override
      {
        return box;
      }

      Box<dim>
      lattice_box(const Box<dim> &cell) const override
      {
        auto corners = cell.get_boundary_points();
        for (unsigned int d = 0; d < dim; ++d)
          {
            corners.first[d]  = std::max(corners.first[d], box.lower_bound(d));
            corners.second[d] = std::min(corners.second[d], box.upper_bound(d));
            corners.second[d] = std::max(corners.second[d], corners.first[d]);
          }
        return Box<dim>(corners);
      }

    private:
      const Box<dim> box;
    };



    template <int dim>
    class EllipsoidRegion : public Region<dim>
    {
    public:
      EllipsoidRegion(const dealii::Point<dim>     &middle,
                      const dealii::Tensor<1, dim> &half_lengths)
        : centre(middle)
        , semi_axes(half_lengths)
      {}

      double
      level(const dealii::Point<dim> &x) const override
      {
        double sum = -1.;
        for (unsigned int d = 0; d < dim; ++d)
          sum += (x[d] - centre[d]) * (x[d] - centre[d]) /
                 (semi_axes[d] * semi_axes[d]);
        return sum;
      }

      double
      volume() const override
      {
        double result = dim == 2 ? M_PI : 4. / 3. * M_PI;
        for (unsigned int d = 0; d < dim; ++d)
          result *= semi_axes[d];
        return result;
      }

      Box<dim>
      bounding_box() const override
      {
        return Box<dim>({centre - semi_axes, centre + semi_axes});
      }

    private:
      const dealii::Point<dim>     centre;
      const dealii::Tensor<1, dim> semi_axes;
    };



    using Vertex  = boost::geometry::model::d2::point_xy<double>;
    using Polygon = boost::geometry::model::polygon<Vertex>;



    /// In 3D a prism along y with vertices x z.
    template <int dim>
    class PolygonRegion : public Region<dim>
    {
    public:
      /// @p along_y: from and to in 3D; without bounds the prism is endless
      /// and @p domain bounds it.
      PolygonRegion(const Polygon                              &outline,
                    const std::optional<std::array<double, 2>> &along_y,
                    const Box<dim>                             &domain)
        : polygon(outline)
        , edges(outline.outer().begin(), outline.outer().end())
        , span(along_y)
        , box(find_box(domain))
      {}

      /// The distance; at the ends of a prism the larger of the distances.
      double
      level(const dealii::Point<dim> &x) const override
      {
        const Vertex place(x[0], x[dim - 1]);
        double       distance = boost::geometry::distance(place, edges);
        if (boost::geometry::within(place, polygon))
          distance = -distance;
        if (span)
          distance = std::max({distance, (*span)[0] - x[1], x[1] - (*span)[1]});
        return distance;
      }

      double
      volume() const override
      {
        const double area = boost::geometry::area(polygon);
        return dim == 2 ? area : area * box.side_length(1);
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



    template <int dim>
    class ExpressionRegion : public Region<dim>
    {
    public:
      ExpressionRegion(Expression<dim> &&level_set, const Box<dim> &whole)
        : function(std::move(level_set))
        , domain(whole)
      {}

      double
      level(const dealii::Point<dim> &x) const override
      {
        return function.value(x, /*t=*/0.);
      }

      Box<dim>
      bounding_box() const override
      {
        return domain;
      }

    private:
      const Expression<dim> function;
      const Box<dim>        domain;
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



    /// Vertices "x y, x y, ..." as a closed polygon of either orientation.
    Polygon
    read_polygon(const InputFile   &input,
                 const std::string &path,
                 const std::string &text)
    {
      const std::vector<double> numbers =
        entry_values::numbers(input, path, text);
      input.require(numbers.size() >= 6 && numbers.size() % 2 == 0,
                    path,
                    fmt::format("{} number(s) given; at least three vertices "
                                "\"x y, x y, ...\" (3D: x z) are needed.",
                                numbers.size()));
      Polygon polygon;
      for (std::size_t i = 0; i < numbers.size(); i += 2)
        polygon.outer().emplace_back(numbers[i], numbers[i + 1]);
      boost::geometry::correct(polygon); // orientation and closing vertex
      input.require(boost::geometry::area(polygon) > 0.,
                    path,
                    "the polygon has no area.");
      input.require(!crosses_itself(polygon.outer()),
                    path,
                    "the edges cross each other; give the vertices in order.");
      return polygon;
    }
  } // namespace



  template <int dim>
  Box<dim>
  Region<dim>::lattice_box(const Box<dim> &cell) const
  {
    return cell;
  }



  namespace
  {
    template <int dim>
    std::unique_ptr<Region<dim>>
    make_box(const InputFile                &input,
             const FluidBodyParameters<dim> &body,
             const Box<dim> &)
    {
      const auto lower = entry_values::point<dim>(input,
                                                  body.path("Lower corner"),
                                                  body.lower_text);
      const auto upper = entry_values::point<dim>(input,
                                                  body.path("Upper corner"),
                                                  body.upper_text);
      for (unsigned int d = 0; d < dim; ++d)
        input.require(lower[d] < upper[d],
                      body.path("Upper corner"),
                      "must be greater than \"Lower corner\" in every "
                      "direction.");
      return std::make_unique<BoxRegion<dim>>(Box<dim>({lower, upper}));
    }



    template <int dim>
    std::unique_ptr<Region<dim>>
    make_ellipsoid(const InputFile                &input,
                   const FluidBodyParameters<dim> &body,
                   const Box<dim> &)
    {
      const auto centre =
        entry_values::point<dim>(input, body.path("Centre"), body.centre_text);
      const bool             ball = body.shape == "ball";
      const std::string      path = body.path(ball ? "Radius" : "Semi-axes");
      dealii::Tensor<1, dim> semi_axes;
      if (ball)
        {
          const double radius =
            entry_values::number(input, path, body.radius_text);
          for (unsigned int d = 0; d < dim; ++d)
            semi_axes[d] = radius;
        }
      else
        semi_axes = entry_values::point<dim>(input, path, body.semi_axes_text);
      for (unsigned int d = 0; d < dim; ++d)
        input.require(semi_axes[d] > 0., path, "must be greater than zero.");
      return std::make_unique<EllipsoidRegion<dim>>(centre, semi_axes);
    }



    template <int dim>
    std::optional<std::array<double, 2>>
    read_span(const InputFile &input, const FluidBodyParameters<dim> &body)
    {
      if (body.span_text.empty())
        return {};
      const auto numbers =
        entry_values::numbers(input, body.path("Span"), body.span_text);
      input.require(numbers.size() == 2 && numbers[0] < numbers[1],
                    body.path("Span"),
                    "must be two numbers in order, from and to in y.");
      return std::array<double, 2>{{numbers[0], numbers[1]}};
    }



    template <int dim>
    std::unique_ptr<Region<dim>>
    make_polygon(const InputFile                &input,
                 const FluidBodyParameters<dim> &body,
                 const Box<dim>                 &domain)
    {
      return std::make_unique<PolygonRegion<dim>>(
        read_polygon(input, body.path("Vertices"), body.vertices_text),
        read_span(input, body),
        domain);
    }



    template <int dim>
    std::unique_ptr<Region<dim>>
    make_expression(const InputFile                &input,
                    const FluidBodyParameters<dim> &body,
                    const Box<dim>                 &domain)
    {
      return std::make_unique<ExpressionRegion<dim>>(
        Expression<dim>(input,
                        body.path("Expression"),
                        body.expression_text,
                        /*n_components=*/1,
                        domain.get_boundary_points().first),
        domain);
    }



    /// One row of the table of shapes.
    template <int dim>
    struct Shape
    {
      const char              *name;
      std::vector<std::string> entries; ///< that it reads
      std::unique_ptr<Region<dim>> (*make)(const InputFile &,
                                           const FluidBodyParameters<dim> &,
                                           const Box<dim> &domain);
    };



    template <int dim>
    const std::vector<Shape<dim>> &
    shapes()
    {
      static const std::vector<Shape<dim>> table = {
        {"box", {"Lower corner", "Upper corner"}, make_box<dim>},
        {"ball", {"Centre", "Radius"}, make_ellipsoid<dim>},
        {"ellipsoid", {"Centre", "Semi-axes"}, make_ellipsoid<dim>},
        {"polygon", {"Vertices", "Span"}, make_polygon<dim>},
        {"expression", {"Expression"}, make_expression<dim>}};
      return table;
    }



    /// InputError unless the body lies in the domain.
    template <int dim>
    void
    require_inside(const InputFile                &input,
                   const FluidBodyParameters<dim> &body,
                   const Box<dim>                 &box,
                   const Box<dim>                 &domain)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double      tolerance = 1e-10 * domain.side_length(d);
          const std::string size =
            body.shape == "box" ?
              (box.lower_bound(d) < domain.lower_bound(d) - tolerance ?
                 "Lower corner" :
                 "Upper corner") :
              (body.shape != "polygon" ? "Centre" :
               dim == 3 && d == 1      ? "Span" :
                                         "Vertices");
          input.require(
            box.lower_bound(d) >= domain.lower_bound(d) - tolerance &&
              box.upper_bound(d) <= domain.upper_bound(d) + tolerance,
            body.path(size),
            fmt::format("the body reaches from {:g} to {:g} m in direction "
                        "{}, outside the domain from {:g} to {:g} m; move it "
                        "or enlarge \"Grid\".",
                        box.lower_bound(d),
                        box.upper_bound(d),
                        "xyz"[d],
                        domain.lower_bound(d),
                        domain.upper_bound(d)));
        }
    }
  } // namespace



  template <int dim>
  void
  FluidBodyParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    std::string names;
    for (const Shape<dim> &row : shapes<dim>())
      names += (names.empty() ? "" : "|") + std::string(row.name);
    prm.enter_subsection("Fluid body " + name);
    prm.add_parameter("Shape",
                      shape,
                      "Shape of the body; each uses its own entries below.",
                      dealii::Patterns::Selection(names));
    prm.add_parameter("Lower corner", lower_text, "Of a box. [m]");
    prm.add_parameter("Upper corner", upper_text, "Of a box. [m]");
    prm.add_parameter("Centre", centre_text, "Of a ball or ellipsoid. [m]");
    prm.add_parameter("Radius", radius_text, "Of a ball. [m]");
    prm.add_parameter("Semi-axes",
                      semi_axes_text,
                      "Of an ellipsoid, one per direction. [m]");
    prm.add_parameter("Vertices",
                      vertices_text,
                      dim == 2 ? "Of a polygon, in order: x y, x y, ... [m]" :
                                 "Of a polygon, in order: x z, x z, ...; the "
                                 "body is a prism along y. [m]");
    if (dim == 3)
      prm.add_parameter("Span",
                        span_text,
                        "Of a polygon: from and to in y; empty: the whole "
                        "domain. [m]");
    prm.add_parameter("Expression",
                      expression_text,
                      "The fluid is where this function of x, y[, z] is "
                      "negative. A continuous one; it is evaluated in the "
                      "whole domain, walls included.");
    prm.add_parameter("Velocity",
                      velocity,
                      "Velocity at the start: one expression of x, y[, z] "
                      "per direction, separated by \";\". [m/s]");
    prm.leave_subsection();
  }



  template <int dim>
  void
  FluidBodyParameters<dim>::check(const InputFile &input) const
  {
    std::map<std::string, std::string> readers; // of an entry: names of shapes
    std::set<std::string>              read;
    for (const Shape<dim> &row : shapes<dim>())
      for (const std::string &entry : row.entries)
        {
          std::string &names = readers[entry];
          names += (names.empty() ? "" : " or ") + std::string(row.name);
          if (shape == row.name)
            read.insert(entry);
        }
    for (const auto &[entry, names] : readers)
      input.read_only_if(read.count(entry) > 0,
                         path(entry),
                         "Shape = " + names);
  }



  template <int dim>
  std::unique_ptr<Region<dim>>
  FluidBodyParameters<dim>::make_region(const InputFile &input,
                                        const Box<dim>  &domain) const
  {
    std::unique_ptr<Region<dim>> region;
    for (const Shape<dim> &row : shapes<dim>())
      if (shape == row.name)
        region = row.make(input, *this, domain);
    Assert(region != nullptr, dealii::ExcInternalError());
    require_inside(input, *this, region->bounding_box(), domain);
    return region;
  }



  template class Region<2>;
  template class Region<3>;
  template struct FluidBodyParameters<2>;
  template struct FluidBodyParameters<3>;
} // namespace seiche
