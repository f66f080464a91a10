// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/shape_table.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <deal.II/physics/transformations.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  ShapeParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    std::string names;
    for (const ShapeKind<dim> &row : shape_table<dim>())
      names += (names.empty() ? "" : "|") + std::string(row.name);
    prm.add_parameter("Shape",
                      shape,
                      "Shape of the body; each uses its own entries below.",
                      Patterns::Selection(names));
    prm.add_parameter("Lower corner", lower_text, "Of a box. [m]");
    prm.add_parameter("Upper corner", upper_text, "Of a box. [m]");
    prm.add_parameter("Centre", centre_text, "Of a ball or ellipsoid. [m]");
    prm.add_parameter("Radius",
                      radius_text,
                      dim == 2 ? "Of a ball. [m]" :
                                 "Of a ball or cylinder. [m]");
    prm.add_parameter("Semi-axes",
                      semi_axes_text,
                      "Of an ellipsoid, one per direction. [m]");
    if (dim == 3)
      prm.add_parameter("Ends",
                        ends_text,
                        "Of a cylinder: centres of its two flat ends, x y z, "
                        "x y z. [m]");
    prm.add_parameter("Point",
                      point_text,
                      "Of a half-space: a place on its plane. [m]");
    prm.add_parameter("Normal",
                      normal_text,
                      "Of a half-space: direction out of it, of any length. "
                      "[-]");
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
                      "The body is where this function of x, y[, z] is "
                      "negative. A continuous one; it is evaluated in the "
                      "whole domain, walls included.");
    prm.add_parameter(
      "Heights",
      heights_text,
      dim == 2 ? "Of a height map: a CSV file with a header, columns x and "
                 "height; the body is below, linear between the rows. [m]" :
                 "Of a height map: a CSV file with a header, columns x, y and "
                 "height on a rectangular lattice, or an ESRI grid (.asc); the "
                 "body is below, bilinear between the places. [m]",
      Patterns::FileName());
    if (dim == 3)
      prm.add_parameter("Triangles",
                        triangles_text,
                        "Of triangles: a file (.stl, .obj, .ply or .off) with "
                        "the closed surface of the body, normals outwards. "
                        "[m]",
                        Patterns::FileName());
    prm.add_parameter("Parts",
                      parts_text,
                      "Of a union, intersection or difference (the first "
                      "without the others): names of subsections \"Shape "
                      "NAME\", separated by commas.");
    prm.add_parameter("Scale",
                      scale,
                      "Sizes and places are multiplied by it. [-]",
                      Patterns::Double(1e-12));
    prm.add_parameter("Rotation",
                      rotation_text,
                      dim == 2 ?
                        "The scaled shape is turned by this angle, from x to "
                        "y; empty: not. [degrees]" :
                        "The scaled shape is turned about this direction by "
                        "this angle: x, y, z, angle; empty: not. [degrees]");
    prm.add_parameter("Pivot",
                      pivot_text,
                      "Place about which it is turned; empty: the origin. "
                      "[m]");
    prm.add_parameter("Shift",
                      shift_text,
                      "What is scaled and turned is moved by this; empty: "
                      "not. [m]");
  }

  template <int dim>
  void
  ShapeParameters<dim>::add_subsection(ParameterHandler &prm)
  {
    prm.enter_subsection(subsection);
    add_parameters(prm);
    prm.leave_subsection();
  }

  template <int dim>
  void
  ShapeParameters<dim>::check(const InputFile &input) const
  {
    std::map<std::string, std::string> readers; // of an entry: names of shapes
    std::set<std::string>              read;
    for (const ShapeKind<dim> &row : shape_table<dim>())
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
    input.read_only_if(!rotation_text.empty(),
                       path("Pivot"),
                       "Rotation = an angle");
  }

  template <int dim>
  std::vector<std::string>
  ShapeParameters<dim>::parts() const
  {
    std::vector<std::string> result = Utilities::split_string_list(parts_text);
    result.erase(std::remove(result.begin(), result.end(), ""), result.end());
    return result;
  }

  template <int dim>
  std::string
  ShapeParameters<dim>::entry_of_extent(const unsigned int direction,
                                        const bool         upwards) const
  {
    if (!shift_text.empty())
      return "Shift";
    if (is_placed())
      return rotation_text.empty() ? "Scale" : "Rotation";
    if (!span_text.empty() && direction == 1)
      return "Span";
    for (const ShapeKind<dim> &row : shape_table<dim>())
      if (shape == row.name)
        return upwards                               ? row.entries.back() :
               row.entries.front() == "Lower corner" ? row.entries.front() :
                                                       row.entries.back();
    return "Shape";
  }

  namespace
  {
    constexpr double degree = dealii::numbers::PI / 180.;

    template <int dim>
    Tensor<2, dim>
    read_rotation(const InputFile   &input,
                  const std::string &path,
                  const std::string &text)
    {
      const auto numbers = entry_values::numbers(input, path, text);
      if constexpr (dim == 2)
        {
          input.require(numbers.size() == 1,
                        path,
                        fmt::format("{} number(s) given; an angle is needed.",
                                    numbers.size()));
          return Physics::Transformations::Rotations::rotation_matrix_2d(
            numbers[0] * degree);
        }
      else
        {
          input.require(numbers.size() == 4,
                        path,
                        fmt::format("{} number(s) given; a direction and an "
                                    "angle are needed: x, y, z, angle.",
                                    numbers.size()));
          const Tensor<1, 3> axis({numbers[0], numbers[1], numbers[2]});
          input.require(axis.norm() > 0.,
                        path,
                        "the direction must not be zero.");
          return Physics::Transformations::Rotations::rotation_matrix_3d(
            axis / axis.norm(), numbers[3] * degree);
        }
    }
  } // namespace

  template <int dim>
  Placement<dim>
  ShapeParameters<dim>::placement(const InputFile &input) const
  {
    Placement<dim> result;
    result.scale = scale;
    if (!rotation_text.empty())
      result.rotation =
        read_rotation<dim>(input, path("Rotation"), rotation_text);
    if (!pivot_text.empty())
      result.pivot = entry_values::point<dim>(input, path("Pivot"), pivot_text);
    if (!shift_text.empty())
      result.shift = entry_values::point<dim>(input, path("Shift"), shift_text);
    return result;
  }

  template <int dim>
  ShapePointer<dim>
  ShapeParameters<dim>::make(const InputFile                    &input,
                             const BoundingBox<dim>             &domain,
                             const std::vector<ShapeParameters> &named) const
  {
    const auto &table = shape_table<dim>();
    const auto  row =
      std::find_if(table.begin(), table.end(), [this](const auto &candidate) {
        return shape == candidate.name;
      });
    Assert(row != table.end(), ExcInternalError());
    if (!is_placed())
      return row->make({input, domain, named}, *this);
    const Placement<dim>   place       = placement(input);
    const BoundingBox<dim> around_here = place.take_back(domain);
    return placed_shape<dim>(row->make({input, around_here, named}, *this),
                             place,
                             domain);
  }

  namespace
  {
    /// InputError if a shape is a part of itself.
    template <int dim>
    void
    check_parts(const InputFile                         &input,
                const std::vector<ShapeParameters<dim>> &shapes,
                const ShapeParameters<dim>              &shape,
                std::vector<std::string>                &way)
    {
      input.require(std::count(way.begin(), way.end(), shape.subsection) == 0,
                    shape.path("Parts"),
                    "a shape cannot be a part of itself, nor of its parts.");
      way.push_back(shape.subsection);
      for (const std::string &name : shape.parts())
        for (const auto &part : shapes)
          if (part.subsection == ShapeParameters<dim>::subsection_of(name))
            check_parts(input, shapes, part, way);
      way.pop_back();
    }
  } // namespace

  template <int dim>
  void
  check_named_shapes(const InputFile                         &input,
                     const std::vector<ShapeParameters<dim>> &shapes,
                     std::vector<std::string>                 used)
  {
    for (const auto &shape : shapes)
      {
        shape.check(input);
        std::vector<std::string> way;
        check_parts(input, shapes, shape, way);
        for (const std::string &name : shape.parts())
          used.push_back(name);
      }
    for (const auto &shape : shapes)
      {
        const bool is_used =
          std::any_of(used.begin(), used.end(), [&](const auto &name) {
            return shape.subsection ==
                   ShapeParameters<dim>::subsection_of(name);
          });
        input.read_only_if(is_used, shape.path("Shape"), "Parts of a body");
      }
  }

#define INSTANTIATE(dim)                                                      \
  template struct ShapeParameters<dim>;                                       \
  template void check_named_shapes(const InputFile &,                         \
                                   const std::vector<ShapeParameters<dim>> &, \
                                   std::vector<std::string>);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
