// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_shape_table_h
#define seiche_scene_shape_table_h

#include <seiche/scene/shape_parameters.h>

#include <string>
#include <vector>

namespace seiche
{
  /// What shapes are made from.
  template <int dim>
  struct ShapeSources
  {
    const InputFile                         &input;
    const dealii::BoundingBox<dim>          &domain;
    const std::vector<ShapeParameters<dim>> &named;
  };

  /// One row of the table of shapes.
  template <int dim>
  struct ShapeKind
  {
    const char              *name;
    std::vector<std::string> entries; ///< that it reads; the last or, of a box,
                                      ///< its corners say how far it reaches
    ShapePointer<dim> (*make)(const ShapeSources<dim>    &sources,
                              const ShapeParameters<dim> &parameters);
  };

  /// THE table of shapes.
  template <int dim>
  const std::vector<ShapeKind<dim>> &
  shape_table();
} // namespace seiche

#endif
