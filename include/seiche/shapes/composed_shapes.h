// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_composed_shapes_h
#define seiche_shapes_composed_shapes_h

#include <seiche/shapes/shape.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace seiche
{
  /// How shapes make another one.
  enum class Composition
  {
    sum,          ///< what is in any of them
    intersection, ///< what is in all of them
    difference    ///< what is in the first and in none of the others
  };

  /// The distance is that of the part which decides: less than the distance
  /// where the nearest place of that part is no place of the surface.
  template <int dim>
  ShapePointer<dim>
  composed_shape(const Composition                composition,
                 std::vector<ShapePointer<dim>> &&parts);

  /// What of the box @p domain is not in the shape.
  template <int dim>
  ShapePointer<dim>
  complement_shape(ShapePointer<dim>             &&shape,
                   const dealii::BoundingBox<dim> &domain);

  /// Where a shape is put: scaled from the origin, then turned about a pivot,
  /// then shifted.
  template <int dim>
  struct Placement
  {
    double                 scale = 1.;
    dealii::Tensor<2, dim> rotation =
      dealii::Tensor<2, dim>(dealii::unit_symmetric_tensor<dim>());
    dealii::Point<dim>     pivot;
    dealii::Tensor<1, dim> shift;

    /// Where @p x of the shape comes to lie, and back.
    dealii::Point<dim>
    place(const dealii::Point<dim> &x) const;
    dealii::Point<dim>
    take_back(const dealii::Point<dim> &x) const;

    /// The smallest box around a placed box, or around what is placed into it.
    dealii::BoundingBox<dim>
    place(const dealii::BoundingBox<dim> &box) const;
    dealii::BoundingBox<dim>
    take_back(const dealii::BoundingBox<dim> &box) const;
  };

  /// What two boxes have in common; flat if they are apart.
  template <int dim>
  dealii::BoundingBox<dim>
  common_box(const dealii::BoundingBox<dim> &a,
             const dealii::BoundingBox<dim> &b);

  /// The box of an endless one ends at that of @p domain.
  template <int dim>
  ShapePointer<dim>
  placed_shape(const SharedShape<dim>         &shape,
               const Placement<dim>           &placement,
               const dealii::BoundingBox<dim> &domain);
} // namespace seiche

#endif
