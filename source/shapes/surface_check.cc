// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/triangle_tree.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

// What TriangleSurface is worth as the bound of a body.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Cosine of the angle between opposite faces of a thin part, at least.
    constexpr double facing = 0.7;

    std::string
    at(const Point<3> &x)
    {
      return fmt::format("at ({:.4g}, {:.4g}, {:.4g})", x[0], x[1], x[2]);
    }

    /// Every edge must be run along once in each sense.
    std::string
    problem_of_edges(const TriangleSurface &surface)
    {
      using Edge = std::pair<unsigned int, unsigned int>;
      std::map<Edge, unsigned int> runs;
      for (const auto &triangle : surface.triangles)
        for (unsigned int e = 0; e < 3; ++e)
          ++runs[{triangle[e], triangle[(e + 1) % 3]}];
      unsigned int open = 0, turned = 0, crowded = 0;
      Point<3>     hole, turn, crowd;
      for (const auto &[edge, n] : runs)
        {
          const auto         back   = runs.find({edge.second, edge.first});
          const unsigned int n_back = back == runs.end() ? 0 : back->second;
          if ((n == 1 && n_back == 1) ||
              (n_back > 0 && edge.first > edge.second)) // seen already
            continue;
          const Point<3> middle(0.5 *
                                (surface.vertices[edge.first] +
                                 Tensor<1, 3>(surface.vertices[edge.second])));
          if (n + n_back == 1)
            {
              ++open;
              hole = middle;
            }
          else if (n + n_back == 2)
            {
              ++turned;
              turn = middle;
            }
          else
            {
              ++crowded;
              crowd = middle;
            }
        }
      if (open > 0)
        return fmt::format("the surface is not closed: {} edge(s) have one "
                           "triangle only, one of them {}; close the holes "
                           "and merge vertices at the same place.",
                           open,
                           at(hole));
      if (crowded > 0)
        return fmt::format("more than two triangles meet in {} edge(s), one "
                           "of them {}; take apart what touches.",
                           crowded,
                           at(crowd));
      if (turned > 0)
        return fmt::format("neighbours are turned differently at {} edge(s), "
                           "one of them {}; let all normals point outwards.",
                           turned,
                           at(turn));
      return "";
    }

    /// Of each part that hangs together: its largest triangle.
    std::vector<unsigned int>
    largest_of_parts(const TriangleSurface &surface)
    {
      std::vector<unsigned int> parent(surface.vertices.size());
      std::iota(parent.begin(), parent.end(), 0);
      const auto root = [&](unsigned int v) {
        for (; parent[v] != v; v = parent[v])
          parent[v] = parent[parent[v]];
        return v;
      };
      for (const auto &triangle : surface.triangles)
        for (unsigned int c = 1; c < 3; ++c)
          parent[root(triangle[c])] = root(triangle[0]);
      std::map<unsigned int, unsigned int> largest;
      for (unsigned int t = 0; t < surface.triangles.size(); ++t)
        {
          const auto known =
            largest.emplace(root(surface.triangles[t][0]), t).first;
          if (surface.area_normal(t).norm() >
              surface.area_normal(known->second).norm())
            known->second = t;
        }
      std::vector<unsigned int> result;
      for (const auto &[part, triangle] : largest)
        result.push_back(triangle);
      return result;
    }

    /// How often all other triangles wind round the middle of this one: one
    /// half if there is nothing outside and the body inside (van Oosterom and
    /// Strackee 1983).
    double
    winding_number(const TriangleSurface &surface, const unsigned int own)
    {
      const Point<3> x     = surface.centre(own);
      double         angle = 0.;
      for (unsigned int t = 0; t < surface.triangles.size(); ++t)
        {
          if (t == own)
            continue;
          std::array<Tensor<1, 3>, 3> r;
          std::array<double, 3>       length;
          for (unsigned int c = 0; c < 3; ++c)
            {
              r[c]      = surface.vertex(t, c) - x;
              length[c] = r[c].norm();
            }
          double below = length[0] * length[1] * length[2];
          for (unsigned int c = 0; c < 3; ++c)
            below += length[c] * (r[(c + 1) % 3] * r[(c + 2) % 3]);
          angle += 2. * std::atan2(r[0] * cross_product_3d(r[1], r[2]), below);
        }
      return angle / (4. * numbers::PI);
    }

    std::string
    problem_of_sides(const TriangleSurface &surface)
    {
      for (const unsigned int triangle : largest_of_parts(surface))
        {
          const double winding = winding_number(surface, triangle);
          if (winding < 0.)
            return fmt::format("the surface is inside out {}: its normals "
                               "point into the body; turn the triangles "
                               "round.",
                               at(surface.centre(triangle)));
          if (winding > 1.)
            return fmt::format("a part of the surface lies inside another one "
                               "{}; unite them, or turn its triangles round "
                               "if it is a hollow.",
                               at(surface.centre(triangle)));
        }
      return "";
    }
  } // namespace

  double
  TriangleSurface::volume() const
  {
    double result = 0.;
    for (unsigned int t = 0; t < triangles.size(); ++t)
      result += (vertex(t, 0) - vertices[0]) * area_normal(t) / 6.;
    return result;
  }

  std::string
  problem_of_surface(const TriangleSurface &surface)
  {
    if (surface.triangles.empty())
      return "there are no triangles.";
    std::string problem = problem_of_edges(surface);
    if (!problem.empty())
      return problem;
    if (const auto pair = TriangleTree(surface).cutting_pair())
      return fmt::format("triangles cut each other near {} and {}; repair the "
                         "surface.",
                         at(surface.centre(pair->first)).substr(3),
                         at(surface.centre(pair->second)).substr(3));
    problem = problem_of_sides(surface);
    if (problem.empty() && !(surface.volume() > 0.))
      return "the body has no volume.";
    return problem;
  }

  Thickness<3>
  least_thickness(const TriangleSurface &surface, const TriangleTree &tree)
  {
    const auto corners = BoundingBox<3>(surface.vertices).get_boundary_points();
    Thickness<3> result;
    for (unsigned int t = 0; t < surface.triangles.size(); ++t)
      {
        const Tensor<1, 3> normal = surface.area_normal(t);
        if (normal.norm() == 0.)
          continue;
        const auto hit =
          tree.first_hit(surface.centre(t),
                         -normal / normal.norm(),
                         std::min(result.length,
                                  corners.first.distance(corners.second)),
                         t);
        if (!hit || hit->way >= result.length)
          continue;
        // what does not face it is a neighbour at an edge
        const Tensor<1, 3> other = surface.area_normal(hit->triangle);
        if (normal * other < -facing * normal.norm() * other.norm())
          result = {hit->way, surface.centre(t)};
      }
    return result;
  }
} // namespace seiche
