// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/body_shapes.h>
#include <seiche/scene/fluid_body.h>
#include <seiche/scene/wall_slack.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace seiche
{
  namespace
  {
    template <int dim>
    using Box = dealii::BoundingBox<dim>;



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
          const double      tolerance = wall_slack(domain.side_length(d));
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
    for (const BodyShape<dim> &row : body_shapes<dim>())
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
    prm.add_parameter("Material",
                      material,
                      "Name of the subsection \"Material NAME\" that "
                      "describes its fluid; empty: subsection Fluid. [-]");
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
    for (const BodyShape<dim> &row : body_shapes<dim>())
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
    for (const BodyShape<dim> &row : body_shapes<dim>())
      if (shape == row.name)
        region = row.make(input, *this, domain);
    Assert(region != nullptr, dealii::ExcInternalError());
    require_inside(input, *this, region->bounding_box(), domain);
    return region;
  }



  namespace
  {
    /// 0: of the Fluid; else place in the list of names and one.
    template <int dim>
    unsigned int
    material_number(const InputFile                &input,
                    const FluidBodyParameters<dim> &body,
                    const std::vector<std::string> &names)
    {
      if (body.material.empty())
        return 0;
      const auto place = std::find(names.begin(), names.end(), body.material);
      input.require(place != names.end(),
                    body.path("Material"),
                    "there is no subsection \"Material " + body.material +
                      "\"; add it with the fluid's Density and Dynamic "
                      "viscosity, or leave the entry empty for that of the "
                      "subsection Fluid.");
      return place - names.begin() + 1;
    }
  } // namespace



  template <int dim>
  std::vector<FluidBody<dim>>
  make_fluid_bodies(const std::vector<FluidBodyParameters<dim>> &bodies,
                    const InputFile                             &input,
                    const Box<dim>                              &domain,
                    const std::vector<std::string>              &material_names)
  {
    input.require(!bodies.empty(),
                  "Fluid body NAME/Shape",
                  "there is no fluid; add at least one subsection \"Fluid "
                  "body NAME\".");
    input.require(bodies.size() < 256,
                  bodies.back().path("Shape"),
                  "at most 255 fluid bodies are possible.");
    std::vector<FluidBody<dim>> result;
    for (const auto &body : bodies)
      {
        FluidBody<dim> made;
        made.name     = body.name;
        made.region   = body.make_region(input, domain);
        made.material = material_number(input, body, material_names);
        // a place inside the body's box: the corner of the domain may be a
        // singular point of the velocity
        made.velocity = std::make_unique<Expression<dim>>(
          input,
          body.path("Velocity"),
          body.velocity,
          dim,
          made.region->bounding_box().center());
        result.push_back(std::move(made));
      }
    return result;
  }



  template struct FluidBodyParameters<2>;
  template struct FluidBodyParameters<3>;
  template std::vector<FluidBody<2>>
  make_fluid_bodies(const std::vector<FluidBodyParameters<2>> &,
                    const InputFile &,
                    const Box<2> &,
                    const std::vector<std::string> &);
  template std::vector<FluidBody<3>>
  make_fluid_bodies(const std::vector<FluidBodyParameters<3>> &,
                    const InputFile &,
                    const Box<3> &,
                    const std::vector<std::string> &);
} // namespace seiche
