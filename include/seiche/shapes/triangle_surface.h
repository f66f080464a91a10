// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_triangle_surface_h
#define seiche_shapes_triangle_surface_h

#include <seiche/shapes/shape.h>

#include <array>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief Triangles that share vertices; seen from outside of the body their
   * vertices run counterclockwise.
   */
  struct TriangleSurface
  {
    using Triangle = std::array<unsigned int, 3>; ///< vertices

    std::vector<dealii::Point<3>> vertices; ///< [m]
    std::vector<Triangle>         triangles;

    dealii::Point<3>
    vertex(const unsigned int triangle, const unsigned int corner) const
    {
      return vertices[triangles[triangle][corner % 3]];
    }

    /// Out of the body, twice the area long [m^2].
    dealii::Tensor<1, 3>
    area_normal(const unsigned int triangle) const
    {
      const auto a = vertex(triangle, 0);
      return cross_product_3d(vertex(triangle, 1) - a, vertex(triangle, 2) - a);
    }

    dealii::Point<3>
    centre(const unsigned int triangle) const
    {
      return dealii::Point<3>((vertex(triangle, 0) +
                               dealii::Tensor<1, 3>(vertex(triangle, 1)) +
                               dealii::Tensor<1, 3>(vertex(triangle, 2))) /
                              3.);
    }

    dealii::BoundingBox<3>
    box(const unsigned int triangle) const
    {
      return dealii::BoundingBox<3>(std::vector<dealii::Point<3>>{
        vertex(triangle, 0), vertex(triangle, 1), vertex(triangle, 2)});
    }

    /// By the divergence theorem [m^3].
    double
    volume() const;
  };

  /// Why the surface bounds no body (holes, edges of more than two triangles,
  /// triangles that are turned round or cut each other), with a place; or
  /// empty.
  std::string
  problem_of_surface(const TriangleSurface &surface);

  /// The distance is exact; its sign is that of the pseudonormal at the nearest
  /// place (Baerentzen and Aanaes 2005). @p surface must have no problem.
  ShapePointer<3>
  triangle_shape(TriangleSurface &&surface);
} // namespace seiche

#endif
