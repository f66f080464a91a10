// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_triangle_tree_h
#define seiche_shapes_triangle_tree_h

#include <seiche/shapes/triangle_surface.h>

#include <memory>
#include <optional>
#include <utility>

namespace seiche
{
  /**
   * @brief Finds triangles of a surface by place, in a tree of their boxes
   * (Boost.Geometry). The surface must outlive it.
   */
  class TriangleTree
  {
  public:
    explicit TriangleTree(const TriangleSurface &surface);
    ~TriangleTree();

    /// The nearest place of the surface.
    struct Nearest
    {
      unsigned int          triangle;
      std::array<double, 3> weights;  ///< of the vertices: sum 1, none negative
      double                distance; ///< [m], not negative
    };
    Nearest
    nearest(const dealii::Point<3> &x) const;

    struct Hit
    {
      unsigned int triangle;
      double       way; ///< [m]
    };
    /// From @p x along the unit vector @p direction to the first triangle other
    /// than @p own, as far as @p longest [m].
    std::optional<Hit>
    first_hit(const dealii::Point<3>     &x,
              const dealii::Tensor<1, 3> &direction,
              const double                longest,
              const unsigned int          own) const;

    /// Two triangles that cut each other in more than what they share.
    std::optional<std::pair<unsigned int, unsigned int>>
    cutting_pair() const;

  private:
    /// Nearer than what is known?
    void
    look_at(const dealii::Point<3> &x,
            const unsigned int      triangle,
            Nearest                &nearest) const;

    struct Boxes;
    const TriangleSurface       &surface;
    const std::unique_ptr<Boxes> boxes;
  };
  /// Least way through the body from the middle of a triangle along its normal
  /// to one that faces it. @p tree: of the surface.
  Thickness<3>
  least_thickness(const TriangleSurface &surface, const TriangleTree &tree);
} // namespace seiche

#endif
