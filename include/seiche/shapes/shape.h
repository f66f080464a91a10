// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_shape_h
#define seiche_shapes_shape_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <limits>
#include <memory>

namespace seiche
{
  /// How thick a shape is where it is thinnest, and a place there.
  template <int dim>
  struct Thickness
  {
    double length = std::numeric_limits<double>::infinity(); ///< [m]
    dealii::Point<dim> place;                                ///< [m]
  };

  /**
   * @brief A part of space, of a fluid body or a wall, by a signed distance.
   */
  template <int dim>
  class Shape
  {
  public:
    virtual ~Shape() = default;

    /// To the surface [m], negative inside. Near the surface its gradient is a
    /// unit vector; far away it may be less than the distance, where a shape
    /// says so.
    virtual double
    distance(const dealii::Point<dim> &x) const = 0;

    /// Unit vector out of the shape, the gradient of the distance: by
    /// differences where a shape does not know it.
    virtual dealii::Tensor<1, dim>
    normal(const dealii::Point<dim> &x) const;

    /// Negative inside, positive outside, of any unit and smooth near the
    /// surface: what shares of boxes are found by.
    virtual double
    level(const dealii::Point<dim> &x) const
    {
      return distance(x);
    }

    /// A box that contains what of the shape lies in the domain.
    virtual dealii::BoundingBox<dim>
    bounding_box() const = 0;

    /// True if it ends nowhere in some direction: its box is that of the domain
    /// there.
    virtual bool
    is_endless() const
    {
      return false;
    }

    /// [m^dim], or not a number if it is not known.
    virtual double
    volume() const
    {
      return std::numeric_limits<double>::quiet_NaN();
    }

    /// True if no place of the surface is nearer than distance() says.
    virtual bool
    bounds_distance() const
    {
      return false;
    }

    /// Infinite if it is not known. May be slow.
    virtual Thickness<dim>
    least_thickness() const
    {
      return {};
    }

    /// True if lattice_box() has no part outside the shape.
    virtual bool
    is_box() const
    {
      return false;
    }

    /// The part of a cell over which the lattice of points is laid. The cell
    /// itself, except for boxes: they are cut exactly, so that their volume
    /// is exact wherever their faces lie. Without volume (upper corner not
    /// above the lower one) if the box does not reach into the cell.
    virtual dealii::BoundingBox<dim>
    lattice_box(const dealii::BoundingBox<dim> &cell) const
    {
      return cell;
    }
  };

  template <int dim>
  using ShapePointer = std::unique_ptr<const Shape<dim>>;
  template <int dim>
  using SharedShape = std::shared_ptr<const Shape<dim>>;
} // namespace seiche

#endif
