// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_polygon_shape_h
#define seiche_shapes_polygon_shape_h

#include <seiche/shapes/shape.h>

#include <array>
#include <optional>
#include <vector>

namespace seiche
{
  using PolygonVertices = std::vector<std::array<double, 2>>; ///< [m]

  /// Why the vertices are no polygon (edges that cross, no area), or empty.
  std::string
  problem_of_polygon(const PolygonVertices &vertices);

  /// A polygon of either orientation (Boost.Geometry); in 3D a prism along y
  /// over its vertices x z, from and to @p span, else through the domain.
  template <int dim>
  ShapePointer<dim>
  polygon_shape(const PolygonVertices                      &vertices,
                const std::optional<std::array<double, 2>> &span,
                const dealii::BoundingBox<dim>             &domain);
} // namespace seiche

#endif
