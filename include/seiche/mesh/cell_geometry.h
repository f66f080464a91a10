// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_cell_geometry_h
#define seiche_mesh_cell_geometry_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  /**
   * @brief The map from the unit cell to a cell: x = lower + edges xi, an
   * axis-parallel box.
   */
  template <int dim>
  struct CellGeometry
  {
    dealii::Point<dim>     lower;        ///< corner [m]
    dealii::Point<dim>     upper;        ///< the opposite one [m]
    dealii::Tensor<1, dim> edges;        ///< lengths [m]
    double                 measure = 0.; ///< volume or area [m^dim]

    CellGeometry() = default;

    CellGeometry(const dealii::Point<dim> &lower_corner,
                 const dealii::Point<dim> &upper_corner)
      : lower(lower_corner)
      , upper(upper_corner)
      , edges(upper_corner - lower_corner)
      , measure(1.)
    {
      for (unsigned int d = 0; d < dim; ++d)
        measure *= edges[d];
    }

    /// Coordinates xi in the unit cell.
    template <typename Number>
    dealii::Point<dim, Number>
    to_unit(const dealii::Point<dim, Number> &x) const
    {
      dealii::Point<dim, Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = (x[d] - lower[d]) / edges[d];
      return result;
    }

    /// Place [m] of coordinates in the unit cell.
    template <typename Number>
    dealii::Point<dim, Number>
    to_real(const dealii::Point<dim, Number> &unit) const
    {
      dealii::Point<dim, Number> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = lower[d] + unit[d] * edges[d];
      return result;
    }

    /// The same for differences of places.
    dealii::Tensor<1, dim>
    to_unit(dealii::Tensor<1, dim> way) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        way[d] /= edges[d];
      return way;
    }
    dealii::Tensor<1, dim>
    to_real(dealii::Tensor<1, dim> way) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        way[d] *= edges[d];
      return way;
    }

    /// Half-open, [lower, upper).
    bool
    holds(const dealii::Point<dim> &x) const
    {
      bool inside = true;
      for (unsigned int d = 0; d < dim; ++d)
        inside &= (x[d] >= lower[d]) & (x[d] < upper[d]);
      return inside;
    }

    /// The nearest place in the closed cell.
    dealii::Point<dim>
    clamped(dealii::Point<dim> x) const
    {
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = std::min(std::max(x[d], lower[d]), upper[d]);
      return x;
    }

    /// Of the unit cell.
    static dealii::Point<dim>
    unit_centre()
    {
      dealii::Point<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = 0.5;
      return result;
    }

    /// |K|^(1/dim) [m]
    double
    size() const
    {
      return dim == 2 ? std::sqrt(measure) : std::cbrt(measure);
    }

    /// [m]
    double
    shortest_edge() const
    {
      return *std::min_element(edges.begin_raw(), edges.end_raw());
    }

    /// True if both differ by a translation, and in the last digits.
    bool
    is_congruent(const CellGeometry &other) const
    {
      constexpr double same = 1e-10;
      return (edges - other.edges).norm() <= same * edges.norm();
    }

    dealii::BoundingBox<dim>
    box() const
    {
      return dealii::BoundingBox<dim>({lower, upper});
    }
  };
} // namespace seiche

#endif
