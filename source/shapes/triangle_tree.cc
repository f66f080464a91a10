// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/triangle_tree.h>

#include <deal.II/boost_adaptors/bounding_box.h>
#include <deal.II/boost_adaptors/point.h>
#include <deal.II/boost_adaptors/segment.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;
  namespace index = boost::geometry::index;

  namespace
  {
    using Entry = std::pair<BoundingBox<3>, unsigned int>;

    /// Weights of the vertices at the nearest place of a triangle (Ericson,
    /// Real-Time Collision Detection 2005, 5.1.5).
    std::array<double, 3>
    nearest_weights(const Point<3> &x,
                    const Point<3> &a,
                    const Point<3> &b,
                    const Point<3> &c)
    {
      const Tensor<1, 3> ab = b - a, ac = c - a;
      const Tensor<1, 3> ax = x - a, bx = x - b, cx = x - c;
      const double       ab_a = ab * ax, ac_a = ac * ax;
      if (ab_a <= 0. && ac_a <= 0.)
        return {{1., 0., 0.}};
      const double ab_b = ab * bx, ac_b = ac * bx;
      if (ab_b >= 0. && ac_b <= ab_b)
        return {{0., 1., 0.}};
      const double of_c = ab_a * ac_b - ab_b * ac_a;
      if (of_c <= 0. && ab_a >= 0. && ab_b <= 0.)
        {
          const double share = ab_a / (ab_a - ab_b);
          return {{1. - share, share, 0.}};
        }
      const double ab_c = ab * cx, ac_c = ac * cx;
      if (ac_c >= 0. && ab_c <= ac_c)
        return {{0., 0., 1.}};
      const double of_b = ab_c * ac_a - ab_a * ac_c;
      if (of_b <= 0. && ac_a >= 0. && ac_c <= 0.)
        {
          const double share = ac_a / (ac_a - ac_c);
          return {{1. - share, 0., share}};
        }
      const double of_a = ab_b * ac_c - ab_c * ac_b;
      const double to_c = ac_b - ab_b, to_b = ab_c - ac_c;
      if (of_a <= 0. && to_c >= 0. && to_b >= 0.)
        {
          const double share = to_c / (to_c + to_b);
          return {{0., 1. - share, share}};
        }
      const double sum = of_a + of_b + of_c;
      return {{of_a / sum, of_b / sum, of_c / sum}};
    }

    /// Share of the way from @p from to @p to at which it meets the triangle
    /// (Moeller and Trumbore 1997).
    std::optional<double>
    crossing(const Point<3> &from,
             const Point<3> &to,
             const Point<3> &a,
             const Point<3> &b,
             const Point<3> &c)
    {
      const Tensor<1, 3> way = to - from, ab = b - a, ac = c - a;
      const Tensor<1, 3> p           = cross_product_3d(way, ac);
      const double       determinant = ab * p;
      // parallel, or a triangle without area
      if (std::abs(determinant) <= 1e-12 * way.norm() * ab.norm() * ac.norm())
        return {};
      const Tensor<1, 3> to_from = from - a;
      const double       u       = (to_from * p) / determinant;
      const Tensor<1, 3> q       = cross_product_3d(to_from, ab);
      const double       v       = (way * q) / determinant;
      const double       share   = (ac * q) / determinant;
      if (u < 0. || v < 0. || u + v > 1. || share < 0. || share > 1.)
        return {};
      return share;
    }

    BoundingBox<3>
    box_of(const Point<3> &a, const Point<3> &b)
    {
      return BoundingBox<3>(std::vector<Point<3>>{a, b});
    }
  } // namespace

  struct TriangleTree::Boxes
  {
    index::rtree<Entry, index::rstar<16>> tree;
  };

  TriangleTree::TriangleTree(const TriangleSurface &its_surface)
    : surface(its_surface)
    , boxes(std::make_unique<Boxes>())
  {
    std::vector<Entry> entries;
    for (unsigned int t = 0; t < surface.triangles.size(); ++t)
      entries.emplace_back(surface.box(t), t);
    boxes->tree = decltype(boxes->tree)(entries.begin(), entries.end());
  }

  TriangleTree::~TriangleTree() = default;

  TriangleTree::Nearest
  TriangleTree::nearest(const Point<3> &x) const
  {
    Nearest            result{0, {}, std::numeric_limits<double>::max()};
    std::vector<Entry> near;
    for (std::size_t n = 8; true; n *= 8)
      {
        near.clear();
        boxes->tree.query(index::nearest(x, n), std::back_inserter(near));
        double farthest = 0.; // of these boxes; all others are beyond it
        for (const auto &[box, triangle] : near)
          {
            look_at(x, triangle, result);
            farthest = std::max(farthest, boost::geometry::distance(x, box));
          }
        if (result.distance <= farthest || near.size() < n)
          return result;
      }
  }

  void
  TriangleTree::look_at(const Point<3>    &x,
                        const unsigned int triangle,
                        Nearest           &nearest) const
  {
    const Point<3> a       = surface.vertex(triangle, 0),
                   b       = surface.vertex(triangle, 1),
                   c       = surface.vertex(triangle, 2);
    const auto     weights = nearest_weights(x, a, b, c);
    const Point<3> place(weights[0] * Tensor<1, 3>(a) +
                         weights[1] * Tensor<1, 3>(b) +
                         weights[2] * Tensor<1, 3>(c));
    const double   distance = x.distance(place);
    if (distance < nearest.distance)
      nearest = {triangle, weights, distance};
  }

  std::optional<TriangleTree::Hit>
  TriangleTree::first_hit(const Point<3>     &x,
                          const Tensor<1, 3> &direction,
                          const double        longest,
                          const unsigned int  own) const
  {
    // Step by step: most ways are short, and a long way's box holds many.
    std::optional<Hit> first;
    double             reached = 0.;
    for (double step = surface.box(own).side_length(0) +
                       surface.box(own).side_length(1) +
                       surface.box(own).side_length(2);
         !first && reached < longest;
         step *= 2.)
      {
        const Point<3> from = x + reached * direction;
        const Point<3> to   = from + step * direction;
        const auto     near = index::intersects(box_of(from, to));
        for (auto found = boxes->tree.qbegin(near); found != boxes->tree.qend();
             ++found)
          {
            const unsigned int t = found->second;
            if (t == own)
              continue;
            const auto share = crossing(from,
                                        to,
                                        surface.vertex(t, 0),
                                        surface.vertex(t, 1),
                                        surface.vertex(t, 2));
            if (share && (!first || reached + *share * step < first->way))
              first = Hit{t, reached + *share * step};
          }
        reached += step;
      }
    return first;
  }

  namespace
  {
    bool
    edge_cuts(const TriangleSurface &surface,
              const unsigned int     edges_of,
              const unsigned int     other)
    {
      const auto &own   = surface.triangles[edges_of];
      const auto &faced = surface.triangles[other];
      for (unsigned int e = 0; e < 3; ++e)
        {
          // an edge that ends in the other triangle meets it there
          if (std::count(faced.begin(), faced.end(), own[e]) > 0 ||
              std::count(faced.begin(), faced.end(), own[(e + 1) % 3]) > 0)
            continue;
          if (crossing(surface.vertex(edges_of, e),
                       surface.vertex(edges_of, e + 1),
                       surface.vertex(other, 0),
                       surface.vertex(other, 1),
                       surface.vertex(other, 2)))
            return true;
        }
      return false;
    }
  } // namespace

  std::optional<std::pair<unsigned int, unsigned int>>
  TriangleTree::cutting_pair() const
  {
    for (unsigned int t = 0; t < surface.triangles.size(); ++t)
      {
        const auto near = index::intersects(surface.box(t));
        for (auto found = boxes->tree.qbegin(near); found != boxes->tree.qend();
             ++found)
          if (found->second > t && (edge_cuts(surface, t, found->second) ||
                                    edge_cuts(surface, found->second, t)))
            return std::make_pair(t, found->second);
      }
    return {};
  }
} // namespace seiche
