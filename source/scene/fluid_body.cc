// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/fluid_body.h>
#include <seiche/scene/wall_slack.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>

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
          const double tolerance = wall_slack(domain.side_length(d));
          const bool   below =
            box.lower_bound(d) < domain.lower_bound(d) - tolerance;
          input.require(
            !below && box.upper_bound(d) <= domain.upper_bound(d) + tolerance,
            body.path(body.shape.entry_of_extent(d, /*upwards=*/!below)),
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
    prm.enter_subsection("Fluid body " + name);
    shape.add_parameters(prm);
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
  ShapePointer<dim>
  FluidBodyParameters<dim>::make_shape(
    const InputFile                         &input,
    const Box<dim>                          &domain,
    const std::vector<ShapeParameters<dim>> &named) const
  {
    ShapePointer<dim> result = shape.make(input, domain, named);
    require_inside(input, *this, result->bounding_box(), domain);
    return result;
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
                    const std::vector<ShapeParameters<dim>>     &named,
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
        made.shape    = body.make_shape(input, domain, named);
        made.material = material_number(input, body, material_names);
        // a place inside the body's box: the corner of the domain may be a
        // singular point of the velocity
        made.velocity = std::make_unique<Expression<dim>>(
          input,
          body.path("Velocity"),
          body.velocity,
          dim,
          made.shape->bounding_box().center());
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
                    const std::vector<ShapeParameters<2>> &,
                    const std::vector<std::string> &);
  template std::vector<FluidBody<3>>
  make_fluid_bodies(const std::vector<FluidBodyParameters<3>> &,
                    const InputFile &,
                    const Box<3> &,
                    const std::vector<ShapeParameters<3>> &,
                    const std::vector<std::string> &);
} // namespace seiche
