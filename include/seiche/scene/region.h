// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_region_h
#define seiche_scene_region_h

#include <seiche/scene/expression.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <limits>
#include <memory>

namespace seiche
{
  /**
   * @brief Shape of a fluid body at the start.
   */
  template <int dim>
  class Region
  {
  public:
    virtual ~Region() = default;

    /// Negative inside, positive outside, of any unit.
    virtual double
    level(const dealii::Point<dim> &x) const = 0;

    /// True if lattice_box() has no part outside the region.
    virtual bool
    is_box() const
    {
      return false;
    }

    /// [m^dim], or not a number if it is not known.
    virtual double
    volume() const
    {
      return std::numeric_limits<double>::quiet_NaN();
    }

    /// A box that contains the region.
    virtual dealii::BoundingBox<dim>
    bounding_box() const = 0;

    /// The part of a cell over which the lattice of points is laid. The cell
    /// itself, except for boxes: they are cut exactly, so that their volume
    /// is exact wherever their faces lie. Without volume (upper corner not
    /// above the lower one) if the box does not reach into the cell.
    virtual dealii::BoundingBox<dim>
    lattice_box(const dealii::BoundingBox<dim> &cell) const;
  };

  template <int dim>
  std::unique_ptr<Region<dim>>
  box_region(const dealii::BoundingBox<dim> &box);

  template <int dim>
  std::unique_ptr<Region<dim>>
  ellipsoid_region(const dealii::Point<dim>     &centre,
                   const dealii::Tensor<1, dim> &semi_axes);

  /// Inside where the expression at t = 0 is negative.
  template <int dim>
  std::unique_ptr<Region<dim>>
  expression_region(Expression<dim>               &&level_set,
                    const dealii::BoundingBox<dim> &domain);
} // namespace seiche

#endif
