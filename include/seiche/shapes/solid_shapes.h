// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_solid_shapes_h
#define seiche_shapes_solid_shapes_h

#include <seiche/shapes/shape.h>

namespace seiche
{
  /// An axis-parallel box; inside, and on it, the nearest face counts.
  template <int dim>
  ShapePointer<dim>
  box_shape(const dealii::BoundingBox<dim> &box);

  /// Semi-axes [m] along the coordinates; the distance is exact for a ball and
  /// to first order near the surface of others.
  template <int dim>
  ShapePointer<dim>
  ellipsoid_shape(const dealii::Point<dim>     &centre,
                  const dealii::Tensor<1, dim> &semi_axes);

  /// Circular, with flat ends at these centres.
  ShapePointer<3>
  cylinder_shape(const dealii::Point<3> &first_end,
                 const dealii::Point<3> &last_end,
                 const double            radius);

  /// Everything behind the plane through @p point whose normal @p outward, of
  /// any length, points out of the shape; its box is that of @p domain.
  template <int dim>
  ShapePointer<dim>
  half_space_shape(const dealii::Point<dim>       &point,
                   const dealii::Tensor<1, dim>   &outward,
                   const dealii::BoundingBox<dim> &domain);
} // namespace seiche

#endif
