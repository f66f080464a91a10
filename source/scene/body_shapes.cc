// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/body_shapes.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/polygon_region.h>

#include <fmt/format.h>

#include <array>
#include <optional>

namespace seiche
{
  namespace
  {
    template <int dim>
    using Box = dealii::BoundingBox<dim>;



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
      return box_region<dim>(Box<dim>({lower, upper}));
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
      return ellipsoid_region<dim>(centre, semi_axes);
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
    std::unique_ptr<Region<dim>>
    make_polygon(const InputFile                &input,
                 const FluidBodyParameters<dim> &body,
                 const Box<dim>                 &domain)
    {
      return polygon_region<dim>(read_vertices(input,
                                               body.path("Vertices"),
                                               body.vertices_text),
                                 read_span(input, body),
                                 domain);
    }



    template <int dim>
    std::unique_ptr<Region<dim>>
    make_expression(const InputFile                &input,
                    const FluidBodyParameters<dim> &body,
                    const Box<dim>                 &domain)
    {
      return expression_region<dim>(
        Expression<dim>(input,
                        body.path("Expression"),
                        body.expression_text,
                        /*n_components=*/1,
                        domain.get_boundary_points().first),
        domain);
    }
  } // namespace



  template <int dim>
  const std::vector<BodyShape<dim>> &
  body_shapes()
  {
    static const std::vector<BodyShape<dim>> table = {
      {"box", {"Lower corner", "Upper corner"}, make_box<dim>},
      {"ball", {"Centre", "Radius"}, make_ellipsoid<dim>},
      {"ellipsoid", {"Centre", "Semi-axes"}, make_ellipsoid<dim>},
      {"polygon", {"Vertices", "Span"}, make_polygon<dim>},
      {"expression", {"Expression"}, make_expression<dim>}};
    return table;
  }



  template const std::vector<BodyShape<2>> &
  body_shapes();
  template const std::vector<BodyShape<3>> &
  body_shapes();
} // namespace seiche
