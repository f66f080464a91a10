// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_fluid_body_h
#define seiche_scene_fluid_body_h

#include <seiche/scene/expression.h>
#include <seiche/scene/shape_parameters.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief prm entries of "Fluid body NAME": shape, material, velocity.
   */
  template <int dim>
  struct FluidBodyParameters
  {
    explicit FluidBodyParameters(const std::string &body_name)
      : name(body_name)
      , shape("Fluid body " + name)
    {}

    std::string          name;
    ShapeParameters<dim> shape;
    std::string velocity = (dim == 2 ? "0; 0" : "0; 0; 0"); // [m/s], (x, t=0)
    std::string material; // name of a Material; empty: of the Fluid

    /// Enters the subsection "Fluid body NAME".
    void
    add_parameters(dealii::ParameterHandler &prm);

    void
    check(const InputFile &input) const
    {
      shape.check(input);
    }

    /// Make the shape; as ShapeParameters::make(), but a body that reaches out
    /// of the @p domain is refused.
    ShapePointer<dim>
    make_shape(const InputFile                         &input,
               const dealii::BoundingBox<dim>          &domain,
               const std::vector<ShapeParameters<dim>> &named) const;

    /// Path of one of this body's entries in the parameter file.
    std::string
    path(const std::string &entry) const
    {
      return path(name, entry);
    }

    static std::string
    path(const std::string &body, const std::string &entry)
    {
      return "Fluid body " + body + "/" + entry;
    }
  };

  /// A fluid body as the entries describe it.
  template <int dim>
  struct FluidBody
  {
    std::string                      name;
    ShapePointer<dim>                shape;
    std::unique_ptr<Expression<dim>> velocity;     ///< [m/s], at t = 0
    unsigned int                     material = 0; ///< 0: of the Fluid
  };

  /// InputError with place for what makes no sense, and for no body at all. @p
  /// domain and @p named as of make_shape(); @p material_names: of the materials beside the
  /// Fluid; @p input must outlive the bodies.
  template <int dim>
  std::vector<FluidBody<dim>>
  make_fluid_bodies(const std::vector<FluidBodyParameters<dim>> &bodies,
                    const InputFile                             &input,
                    const dealii::BoundingBox<dim>              &domain,
                    const std::vector<ShapeParameters<dim>>     &named,
                    const std::vector<std::string> &material_names);
} // namespace seiche

#endif
