// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/expression_shape.h>
#include <seiche/scene/height_map_file.h>
#include <seiche/scene/shape_table.h>
#include <seiche/scene/surface_file.h>
#include <seiche/shapes/polygon_shape.h>
#include <seiche/shapes/solid_shapes.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Sources = ShapeSources<dim>;
    template <int dim>
    using Entries = ShapeParameters<dim>;

    template <int dim>
    Point<dim>
    read_point(const Sources<dim> &sources,
               const Entries<dim> &entries,
               const std::string  &name,
               const std::string  &text)
    {
      return entry_values::point<dim>(sources.input, entries.path(name), text);
    }

    template <int dim>
    ShapePointer<dim>
    make_box(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      const auto lower =
        read_point(sources, entries, "Lower corner", entries.lower_text);
      const auto upper =
        read_point(sources, entries, "Upper corner", entries.upper_text);
      for (unsigned int d = 0; d < dim; ++d)
        sources.input.require(lower[d] < upper[d],
                              entries.path("Upper corner"),
                              "must be greater than \"Lower corner\" in every "
                              "direction.");
      return box_shape<dim>(BoundingBox<dim>({lower, upper}));
    }

    /// A number greater than zero.
    double
    length(const InputFile   &input,
           const std::string &path,
           const std::string &text)
    {
      const double result = entry_values::number(input, path, text);
      input.require(result > 0., path, "must be greater than zero.");
      return result;
    }

    template <int dim>
    ShapePointer<dim>
    make_ball(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      const auto centre =
        read_point(sources, entries, "Centre", entries.centre_text);
      Tensor<1, dim> semi_axes;
      for (unsigned int d = 0; d < dim; ++d)
        semi_axes[d] =
          length(sources.input, entries.path("Radius"), entries.radius_text);
      return ellipsoid_shape<dim>(centre, semi_axes);
    }

    template <int dim>
    ShapePointer<dim>
    make_ellipsoid(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      const auto centre =
        read_point(sources, entries, "Centre", entries.centre_text);
      const auto semi_axes =
        read_point(sources, entries, "Semi-axes", entries.semi_axes_text);
      for (unsigned int d = 0; d < dim; ++d)
        sources.input.require(semi_axes[d] > 0.,
                              entries.path("Semi-axes"),
                              "must be greater than zero.");
      return ellipsoid_shape<dim>(centre, semi_axes);
    }

    ShapePointer<3>
    make_cylinder(const Sources<3> &sources, const Entries<3> &entries)
    {
      const std::string path = entries.path("Ends");
      const auto        numbers =
        entry_values::numbers(sources.input, path, entries.ends_text);
      sources.input.require(
        numbers.size() == 6,
        path,
        fmt::format("{} number(s) given; the centres of both ends are needed: "
                    "x y z, x y z.",
                    numbers.size()));
      const Point<3> first(numbers[0], numbers[1], numbers[2]),
        last(numbers[3], numbers[4], numbers[5]);
      sources.input.require(first.distance(last) > 0.,
                            path,
                            "the two ends must not be the same place.");
      return cylinder_shape(first,
                            last,
                            length(sources.input,
                                   entries.path("Radius"),
                                   entries.radius_text));
    }

    template <int dim>
    ShapePointer<dim>
    make_half_space(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      const auto point =
        read_point(sources, entries, "Point", entries.point_text);
      const auto normal =
        read_point(sources, entries, "Normal", entries.normal_text);
      sources.input.require(normal.norm() > 0.,
                            entries.path("Normal"),
                            "must not be zero in all directions.");
      return half_space_shape<dim>(point, normal, sources.domain);
    }

    template <int dim>
    std::optional<std::array<double, 2>>
    read_span(const InputFile &input, const Entries<dim> &entries)
    {
      if (entries.span_text.empty())
        return {};
      const auto numbers =
        entry_values::numbers(input, entries.path("Span"), entries.span_text);
      input.require(numbers.size() == 2 && numbers[0] < numbers[1],
                    entries.path("Span"),
                    "must be two numbers in order, from and to in y.");
      return std::array<double, 2>{{numbers[0], numbers[1]}};
    }

    /// Vertices "x y, x y, ...".
    PolygonVertices
    read_vertices(const InputFile   &input,
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
      PolygonVertices vertices;
      for (std::size_t i = 0; i < numbers.size(); i += 2)
        vertices.push_back({{numbers[i], numbers[i + 1]}});
      const std::string problem = problem_of_polygon(vertices);
      input.require(problem.empty(), path, problem);
      return vertices;
    }

    template <int dim>
    ShapePointer<dim>
    make_polygon(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      return polygon_shape<dim>(read_vertices(sources.input,
                                              entries.path("Vertices"),
                                              entries.vertices_text),
                                read_span(sources.input, entries),
                                sources.domain);
    }

    template <int dim>
    ShapePointer<dim>
    make_expression(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      return expression_shape<dim>(
        Expression<dim>(sources.input,
                        entries.path("Expression"),
                        entries.expression_text,
                        /*n_components=*/1,
                        sources.domain.get_boundary_points().first),
        sources.domain);
    }

    template <int dim>
    ShapePointer<dim>
    make_height_map(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      return height_map_shape<dim>(read_height_map<dim>(sources.input,
                                                        entries.path("Heights"),
                                                        entries.heights_text,
                                                        sources.domain),
                                   sources.domain);
    }

    ShapePointer<3>
    make_triangles(const Sources<3> &sources, const Entries<3> &entries)
    {
      sources.input.cites("baerentzen2005");
      return triangle_shape(read_surface(sources.input,
                                         entries.path("Triangles"),
                                         entries.triangles_text));
    }

    template <int dim>
    ShapePointer<dim>
    make_part(const Sources<dim> &sources,
              const Entries<dim> &whole,
              const std::string  &name)
    {
      const auto part = std::find_if(sources.named.begin(),
                                     sources.named.end(),
                                     [&](const auto &shape) {
                                       return shape.subsection ==
                                              Entries<dim>::subsection_of(name);
                                     });
      sources.input.require(part != sources.named.end(),
                            whole.path("Parts"),
                            fmt::format("there is no subsection \"Shape {}\"; "
                                        "add it, or name another one.",
                                        name));
      return part->make(sources.input, sources.domain, sources.named);
    }

    template <int dim, Composition composition>
    ShapePointer<dim>
    make_composed(const Sources<dim> &sources, const Entries<dim> &entries)
    {
      std::vector<ShapePointer<dim>> parts;
      for (const std::string &name : entries.parts())
        parts.push_back(make_part(sources, entries, name));
      sources.input.require(
        !parts.empty(),
        entries.path("Parts"),
        "names of shapes (subsections \"Shape NAME\") are needed, separated "
        "by commas.");
      return composed_shape<dim>(composition, std::move(parts));
    }
  } // namespace

  template <int dim>
  const std::vector<ShapeKind<dim>> &
  shape_table()
  {
    static const std::vector<ShapeKind<dim>> table = []() {
      std::vector<ShapeKind<dim>> rows = {
        {"box", {"Lower corner", "Upper corner"}, make_box<dim>},
        {"ball", {"Radius", "Centre"}, make_ball<dim>},
        {"ellipsoid", {"Semi-axes", "Centre"}, make_ellipsoid<dim>}};
      if constexpr (dim == 3)
        rows.push_back({"cylinder", {"Radius", "Ends"}, make_cylinder});
      if constexpr (dim == 3)
        rows.push_back({"triangles", {"Triangles"}, make_triangles});
      const std::vector<ShapeKind<dim>> others = {
        {"half-space", {"Normal", "Point"}, make_half_space<dim>},
        {"polygon", {"Span", "Vertices"}, make_polygon<dim>},
        {"expression", {"Expression"}, make_expression<dim>},
        {"height map", {"Heights"}, make_height_map<dim>},
        {"union", {"Parts"}, make_composed<dim, Composition::sum>},
        {"intersection",
         {"Parts"},
         make_composed<dim, Composition::intersection>},
        {"difference", {"Parts"}, make_composed<dim, Composition::difference>}};
      rows.insert(rows.end(), others.begin(), others.end());
      return rows;
    }();
    return table;
  }

  template const std::vector<ShapeKind<2>> &
  shape_table();
  template const std::vector<ShapeKind<3>> &
  shape_table();
} // namespace seiche
