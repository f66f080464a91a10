// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_solid_h
#define seiche_scene_solid_h

#include <seiche/scene/shape_parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief A wall of any shape, whose surface cuts through cells.
   */
  template <int dim>
  struct Solid
  {
    std::string                       name;
    std::shared_ptr<const Shape<dim>> shape; ///< where there is no fluid
  };

  /// The solid that a place is nearest to, or farthest in; null without any.
  template <int dim>
  const Solid<dim> *
  nearest_solid(const std::vector<Solid<dim>> &solids,
                const dealii::Point<dim>      &x);

  /// prm entries of "Solid NAME".
  template <int dim>
  struct SolidParameters
  {
    static constexpr const char *kind = "Solid";

    explicit SolidParameters(const std::string &solid_name)
      : name(solid_name)
      , shape(std::string(kind) + " " + solid_name)
    {}

    std::string          name;
    ShapeParameters<dim> shape;
    std::string          side = "outside";

    /// Enters the subsection.
    void
    add_parameters(dealii::ParameterHandler &prm);

    void
    check(const InputFile &input) const
    {
      shape.check(input);
    }
  };

  /// InputError with place for what makes no sense. @p domain and @p named as
  /// of ShapeParameters::make(); @p input must outlive the solids.
  template <int dim>
  std::vector<Solid<dim>>
  make_solids(const std::vector<SolidParameters<dim>> &solids,
              const InputFile                         &input,
              const dealii::BoundingBox<dim>          &domain,
              const std::vector<ShapeParameters<dim>> &named);
} // namespace seiche

#endif
