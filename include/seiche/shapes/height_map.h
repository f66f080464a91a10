// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_height_map_h
#define seiche_shapes_height_map_h

#include <seiche/shapes/shape.h>

#include <array>
#include <vector>

namespace seiche
{
  /**
   * @brief Heights [m] above a line or a rectangular lattice, multilinear
   * between its places.
   */
  template <int dim>
  struct HeightMap
  {
    /// Places along x, in 3D along x and y [m]; ascending, two at least.
    std::array<std::vector<double>, dim - 1> places;
    std::vector<double>                      heights; ///< x runs fastest

    /// Height and slopes at a place; beyond the map those of its edge.
    std::pair<double, dealii::Tensor<1, dim - 1>>
    at(const dealii::Point<dim> &x) const;
  };

  /// Everything below the heights; the distance is exact to first order near
  /// the surface. Its box is that of @p domain up to the greatest height.
  template <int dim>
  ShapePointer<dim>
  height_map_shape(HeightMap<dim>                &&map,
                   const dealii::BoundingBox<dim> &domain);
} // namespace seiche

#endif
