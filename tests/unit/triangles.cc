// SPDX-License-Identifier: LGPL-2.1-or-later
// Bodies of triangles from files: volume, distance and normal, the box, the
// thinnest place; each surface that bounds no body is refused.
#include <seiche/shapes/triangle_tree.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>

#include "shape_checks.h"

namespace
{
  using seiche::TriangleSurface;

  /// A prism along y over an outline x z, which runs from x to z and which all
  /// of whose corners its first one sees.
  TriangleSurface
  prism(const std::vector<std::array<double, 2>> &outline,
        const double                              from,
        const double                              to)
  {
    TriangleSurface    result;
    const unsigned int n = outline.size();
    for (const double y : {from, to})
      for (const auto &corner : outline)
        result.vertices.emplace_back(corner[0], y, corner[1]);
    for (unsigned int i = 1; i + 1 < n; ++i)
      {
        result.triangles.push_back({{0, i, i + 1}});
        result.triangles.push_back({{n, n + i + 1, n + i}});
      }
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int next = (i + 1) % n;
        result.triangles.push_back({{i, n + i, next}});
        result.triangles.push_back({{next, n + i, n + next}});
      }
    return result;
  }

  TriangleSurface
  box(const double lower, const double upper)
  {
    return prism(
      {{{lower, lower}}, {{upper, lower}}, {{upper, upper}}, {{lower, upper}}},
      lower,
      upper);
  }

  TriangleSurface
  turned(TriangleSurface surface)
  {
    for (auto &triangle : surface.triangles)
      std::swap(triangle[0], triangle[1]);
    return surface;
  }

  TriangleSurface
  both(TriangleSurface surface, const TriangleSurface &other)
  {
    const unsigned int n = surface.vertices.size();
    surface.vertices.insert(surface.vertices.end(),
                            other.vertices.begin(),
                            other.vertices.end());
    for (auto triangle : other.triangles)
      {
        for (unsigned int &vertex : triangle)
          vertex += n;
        surface.triangles.push_back(triangle);
      }
    return surface;
  }

  void
  write_stl(const TriangleSurface &surface, const std::string &name)
  {
    std::ofstream file(name);
    file << "solid body\n";
    for (unsigned int t = 0; t < surface.triangles.size(); ++t)
      {
        file << "facet normal 0 0 0\nouter loop\n";
        for (unsigned int c = 0; c < 3; ++c)
          file << "vertex " << surface.vertex(t, c) << "\n";
        file << "endloop\nendfacet\n";
      }
    file << "endsolid body\n";
  }

  void
  write_binary_stl(const TriangleSurface &surface, const std::string &name)
  {
    std::ofstream file(name, std::ios::binary);
    const auto    put = [&file](const auto value) {
      file.write(reinterpret_cast<const char *>(&value), sizeof(value));
    };
    file << std::string(80, ' ');
    put(static_cast<std::uint32_t>(surface.triangles.size()));
    for (unsigned int t = 0; t < surface.triangles.size(); ++t)
      {
        for (unsigned int d = 0; d < 3; ++d)
          put(0.f);
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int d = 0; d < 3; ++d)
            put(static_cast<float>(surface.vertex(t, c)[d]));
        put(std::uint16_t(0));
      }
  }

  void
  write_obj(const TriangleSurface &surface, const std::string &name)
  {
    std::ofstream file(name);
    for (const auto &vertex : surface.vertices)
      file << "v " << vertex << "\n";
    for (const auto &triangle : surface.triangles)
      file << "f " << triangle[0] + 1 << " " << triangle[1] + 1 << " "
           << triangle[2] + 1 << "\n";
  }

  std::string
  entries(const std::string &file)
  {
    return "set Shape = triangles\n set Triangles = " + file + "\n";
  }

  void
  refused_surface(const TriangleSurface &surface)
  {
    write_stl(surface, "refused.stl");
    refused<3>(entries("refused.stl"));
  }

  /// An L: an edge that turns inwards.
  TriangleSurface
  with_notch()
  {
    return prism({{{0.5, 0.5}},
                  {{0.5, 0.875}},
                  {{0.25, 0.875}},
                  {{0.25, 0.125}},
                  {{1.5, 0.125}},
                  {{1.5, 0.5}}},
                 0.25,
                 0.75);
  }

  void
  test_bodies()
  {
    const Point<3> lower(0.25, 0.25, 0.125), upper(1.5, 0.75, 0.875);
    const double   volume = 0.5 * (0.25 * 0.75 + 1. * 0.375);
    write_stl(with_notch(), "body.stl");
    test<3>("STL", entries("body.stl"), volume, lower, upper, 1e-4);
    write_binary_stl(with_notch(), "binary.stl");
    test<3>("binary STL", entries("binary.stl"), volume, lower, upper, 1e-4);
    write_obj(with_notch(), "body.obj");
    test<3>("OBJ", entries("body.obj"), volume, lower, upper, 1e-4);

    write_stl(both(box(0.125, 0.875), turned(box(0.25, 0.625))), "hollow.stl");
    test<3>("hollow box",
            entries("hollow.stl"),
            0.75 * 0.75 * 0.75 - 0.375 * 0.375 * 0.375,
            {0.125, 0.125, 0.125},
            {0.875, 0.875, 0.875},
            1e-4);
    test<3>("box of half the size, moved",
            entries("hollow.stl") + " set Scale = 0.5\n set Shift = 1, 0, 0\n",
            0.125 * (0.75 * 0.75 * 0.75 - 0.375 * 0.375 * 0.375),
            {1.0625, 0.0625, 0.0625},
            {1.4375, 0.4375, 0.4375},
            1e-4);
  }

  void
  test_thickness()
  {
    const TriangleSurface notched = with_notch();
    const auto            least =
      seiche::least_thickness(notched, seiche::TriangleTree(notched));
    std::cout << "thinnest: " << least.length << " m, of the hollow box ";
    const auto scene =
      scene_with<3>(entries("hollow.stl") + " set Scale = 0.5\n", "");
    std::cout << scene->bodies[0].shape->least_thickness().length << " m"
              << std::endl;
  }

  /// Of radius 0.4 about (1, 0.5, 0.5).
  TriangleSurface
  ball(const unsigned int n)
  {
    TriangleSurface    result;
    const Point<3>     centre(1., 0.5, 0.5);
    const unsigned int around = 2 * n;
    const auto         add    = [&](const double polar, const double angle) {
      result.vertices.emplace_back(
        centre + 0.4 * Tensor<1, 3>({std::sin(polar) * std::cos(angle),
                                     std::sin(polar) * std::sin(angle),
                                     std::cos(polar)}));
    };
    add(0., 0.);
    for (unsigned int i = 1; i < n; ++i)
      for (unsigned int k = 0; k < around; ++k)
        add(i * dealii::numbers::PI / n, k * 2. * dealii::numbers::PI / around);
    add(dealii::numbers::PI, 0.);
    const unsigned int last = result.vertices.size() - 1;
    const auto number       = [&](const unsigned int i, const unsigned int k) {
      return 1 + (i - 1) * around + k % around;
    };
    for (unsigned int k = 0; k < around; ++k)
      {
        result.triangles.push_back({{0, number(1, k), number(1, k + 1)}});
        result.triangles.push_back(
          {{last, number(n - 1, k + 1), number(n - 1, k)}});
        for (unsigned int i = 1; i + 1 < n; ++i)
          {
            result.triangles.push_back(
              {{number(i, k), number(i + 1, k), number(i + 1, k + 1)}});
            result.triangles.push_back(
              {{number(i, k), number(i + 1, k + 1), number(i, k + 1)}});
          }
      }
    return result;
  }

  /// Of many triangles, near and far: against that of the ball, between which
  /// and the triangles there is 0.4 (1 - cos) of half an edge's angle.
  void
  test_far_distance()
  {
    const unsigned int         n       = 20;
    const TriangleSurface      surface = ball(n);
    const auto                 shape   = seiche::triangle_shape(ball(n));
    const seiche::TriangleTree tree(surface);
    std::mt19937               random(1);
    std::uniform_real_distribution<double> place(0., 1.);
    bool                                   good = true;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const Point<3> x(2. * place(random), place(random), place(random));
        // all triangles, by the tree of one
        double least = 1e9;
        for (const auto &triangle : surface.triangles)
          {
            TriangleSurface one;
            one.triangles = {{{0, 1, 2}}};
            for (const unsigned int vertex : triangle)
              one.vertices.push_back(surface.vertices[vertex]);
            least =
              std::min(least, seiche::TriangleTree(one).nearest(x).distance);
          }
        const double exact    = x.distance(Point<3>(1., 0.5, 0.5)) - 0.4;
        const double distance = shape->distance(x);
        good = good && std::abs(std::abs(distance) - least) < 1e-12 &&
               std::abs(distance - exact) < 0.01;
      }
    std::cout << surface.triangles.size()
              << " triangles, near and far: " << verdict(good) << std::endl;
  }

  void
  test_refused()
  {
    TriangleSurface open = box(0.25, 0.75);
    open.triangles.pop_back();
    refused_surface(open);
    refused_surface(turned(box(0.25, 0.75)));
    TriangleSurface mixed = box(0.25, 0.75);
    std::swap(mixed.triangles[0][0], mixed.triangles[0][1]);
    refused_surface(mixed);
    refused_surface(both(box(0.25, 0.75), box(0.5, 1.)));
    refused_surface(both(box(0.25, 0.75), box(0.375, 0.5)));
    refused_surface(both(box(0.25, 0.75), turned(box(1., 2.))));
    TriangleSurface crowded = box(0.25, 0.75);
    crowded.triangles.push_back(crowded.triangles.front());
    refused_surface(crowded);
    refused_surface({});
    TriangleSurface without_number = box(0.25, 0.75);
    without_number.vertices[0][0]  = std::numeric_limits<double>::quiet_NaN();
    write_binary_stl(without_number, "refused.stl");
    refused<3>(entries("refused.stl"));
    std::ofstream("noise.stl") << "nothing of the kind";
    refused<3>(entries("noise.stl"));
    std::ofstream("body.dxf") << "0";
    refused<3>(entries("body.dxf"));
    refused<3>(entries("none.stl"));
    refused<3>("set Shape = triangles\n");
    write_stl(box(0.5, 1.5), "outside.stl");
    refused<3>(entries("outside.stl"));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_bodies();
  test_thickness();
  test_far_distance();
  test_refused();
}
