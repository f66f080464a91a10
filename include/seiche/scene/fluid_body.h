// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_fluid_body_h
#define seiche_scene_fluid_body_h

#include <seiche/scene/region.h>

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
   * @brief prm entries of "Fluid body NAME": shape, its sizes, velocity.
   *
   * Shapes: box (corners), ellipsoid (centre, semi-axes; ball: one radius),
   * polygon (vertices; Boost.Geometry; in 3D a prism along y), expression
   * (inside where < 0).
   */
  template <int dim>
  struct FluidBodyParameters
  {
    std::string name;
    std::string shape = "box";
    std::string lower_text, upper_text, centre_text, radius_text,
      semi_axes_text, vertices_text, span_text, expression_text;
    std::string velocity = (dim == 2 ? "0; 0" : "0; 0; 0"); // [m/s], (x, t=0)
    std::string material; // name of a Material; empty: of the Fluid

    /// Enters the subsection "Fluid body NAME"; set the name before.
    void
    add_parameters(dealii::ParameterHandler &prm);

    void
    check(const InputFile &input) const;

    /// Make the region; InputError with place for bad sizes. @p domain is the
    /// box of the grid: a body that reaches out of it is refused. @p input
    /// must outlive the region.
    std::unique_ptr<Region<dim>>
    make_region(const InputFile                &input,
                const dealii::BoundingBox<dim> &domain) const;

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
    std::unique_ptr<Region<dim>>     region;
    std::unique_ptr<Expression<dim>> velocity;     ///< [m/s], at t = 0
    unsigned int                     material = 0; ///< 0: of the Fluid
  };

  /// InputError with place for what makes no sense, and for no body at all. @p
  /// domain as of make_region(); @p material_names: of the materials beside the
  /// Fluid; @p input must outlive the bodies.
  template <int dim>
  std::vector<FluidBody<dim>>
  make_fluid_bodies(const std::vector<FluidBodyParameters<dim>> &bodies,
                    const InputFile                             &input,
                    const dealii::BoundingBox<dim>              &domain,
                    const std::vector<std::string> &material_names);
} // namespace seiche

#endif
