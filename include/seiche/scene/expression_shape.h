// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_expression_shape_h
#define seiche_scene_expression_shape_h

#include <seiche/scene/expression.h>
#include <seiche/shapes/shape.h>

namespace seiche
{
  /// Inside where the expression at t = 0 is negative; the distance is the
  /// value over the length of its gradient, exact to first order near the
  /// surface. Its box is that of @p domain.
  template <int dim>
  ShapePointer<dim>
  expression_shape(Expression<dim>               &&level,
                   const dealii::BoundingBox<dim> &domain);
} // namespace seiche

#endif
