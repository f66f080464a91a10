// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/triangle_tree.h>
#include <seiche/shapes/unit_vector.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    double
    angle_between(const Tensor<1, 3> &a, const Tensor<1, 3> &b)
    {
      return std::atan2(cross_product_3d(a, b).norm(), a * b);
    }

    /// Outward directions of any length at what is nearest: a triangle, an edge
    /// (sum of both unit normals) or a vertex (unit normals weighted by the
    /// angles).
    class Pseudonormals
    {
    public:
      explicit Pseudonormals(const TriangleSurface &its_surface)
        : surface(its_surface)
        , of_vertex(surface.vertices.size())
      {
        for (unsigned int t = 0; t < surface.triangles.size(); ++t)
          {
            const Tensor<1, 3> area   = surface.area_normal(t);
            const double       length = area.norm();
            of_triangle.push_back(length > 0. ? area / length : area);
            for (unsigned int c = 0; c < 3; ++c)
              {
                const Point<3> x = surface.vertex(t, c);
                of_vertex[surface.triangles[t][c]] +=
                  angle_between(surface.vertex(t, c + 1) - x,
                                surface.vertex(t, c + 2) - x) *
                  of_triangle[t];
                of_edge[edge(t, c)] += of_triangle[t];
              }
          }
      }

      Tensor<1, 3>
      at(const TriangleTree::Nearest &nearest) const
      {
        const auto        &w = nearest.weights;
        const unsigned int t = nearest.triangle;
        const auto         n = std::count(w.begin(), w.end(), 0.);
        if (n == 2)
          return of_vertex[surface.triangles[t][std::max_element(w.begin(),
                                                                 w.end()) -
                                                w.begin()]];
        if (n == 1)
          return of_edge.at(
            edge(t, std::find(w.begin(), w.end(), 0.) - w.begin() + 1));
        return of_triangle[t];
      }

    private:
      using Edge = std::pair<unsigned int, unsigned int>;

      Edge
      edge(const unsigned int triangle, const unsigned int from) const
      {
        const auto &vertices = surface.triangles[triangle];
        return std::minmax({vertices[from % 3], vertices[(from + 1) % 3]});
      }

      const TriangleSurface       &surface;
      std::vector<Tensor<1, 3>>    of_triangle, of_vertex;
      std::map<Edge, Tensor<1, 3>> of_edge;
    };

    class TriangleShape : public Shape<3>
    {
    public:
      explicit TriangleShape(TriangleSurface &&its_surface)
        : surface(std::move(its_surface))
        , tree(surface)
        , pseudonormals(surface)
        , box(surface.vertices)
        , its_volume(surface.volume())
      {}

      double
      distance(const Point<3> &x) const override
      {
        const auto nearest = tree.nearest(x);
        return is_inside(x, nearest) ? -nearest.distance : nearest.distance;
      }

      Tensor<1, 3>
      normal(const Point<3> &x) const override
      {
        const auto         nearest   = tree.nearest(x);
        const Tensor<1, 3> direction = x - place(nearest);
        // on the surface there is no other direction
        if (nearest.distance < 1e-9 * box.side_length(0))
          return unit_vector(pseudonormals.at(nearest));
        return unit_vector(is_inside(x, nearest) ? -direction : direction);
      }

      BoundingBox<3>
      bounding_box() const override
      {
        return box;
      }

      double
      volume() const override
      {
        return its_volume;
      }

      bool
      bounds_distance() const override
      {
        return true;
      }

      Thickness<3>
      least_thickness() const override
      {
        return seiche::least_thickness(surface, tree);
      }

    private:
      Point<3>
      place(const TriangleTree::Nearest &nearest) const
      {
        Tensor<1, 3> result;
        for (unsigned int c = 0; c < 3; ++c)
          result += nearest.weights[c] *
                    Tensor<1, 3>(surface.vertex(nearest.triangle, c));
        return Point<3>(result);
      }

      bool
      is_inside(const Point<3> &x, const TriangleTree::Nearest &nearest) const
      {
        return (x - place(nearest)) * pseudonormals.at(nearest) < 0.;
      }

      const TriangleSurface surface;
      const TriangleTree    tree;
      const Pseudonormals   pseudonormals;
      const BoundingBox<3>  box;
      const double          its_volume;
    };
  } // namespace

  ShapePointer<3>
  triangle_shape(TriangleSurface &&surface)
  {
    return std::make_unique<TriangleShape>(std::move(surface));
  }
} // namespace seiche
