// SPDX-License-Identifier: LGPL-2.1-or-later
// Area of each shape, summed over boxes, and the refused bodies.
#include <seiche/scene/box_part.h>
#include <seiche/scene/fluid_body.h>

#include <cmath>

#include "scene_from_text.h"

namespace
{
  const std::string grid = "subsection Grid\n"
                           "  set Lower corner = 0, 0\n"
                           "  set Upper corner = 2, 1\n"
                           "  set Cell size = 0.1\n"
                           "end\n";

  std::unique_ptr<seiche::Region<2>>
  make(const std::string &entries, std::unique_ptr<SceneFromText<2>> &scene)
  {
    scene = std::make_unique<SceneFromText<2>>(
      grid + "subsection Fluid body a\n" + entries + "end\n");
    return std::move(scene->bodies[0].region);
  }



  /// Area, summed over boxes, and box.
  void
  measure(const char             *name,
          const std::string      &entries,
          const double            exact_area,
          const dealii::Point<2> &lower_corner,
          const dealii::Point<2> &upper_corner)
  {
    std::unique_ptr<SceneFromText<2>> scene;
    const auto                        region = make(entries, scene);
    constexpr double                  edge   = 0.025;
    double                            area   = 0.;
    for (unsigned int i = 0; i < 80; ++i)
      for (unsigned int j = 0; j < 40; ++j)
        {
          const dealii::Point<2>       lower(i * edge, j * edge);
          const dealii::BoundingBox<2> box(
            {lower, lower + dealii::Tensor<1, 2>({edge, edge})});
          area += edge * edge *
                  seiche::part_inside<2>(
                    [&](const auto &x) { return region->level(x); }, box)
                    .share;
        }
    const auto corners = region->bounding_box().get_boundary_points();
    std::cout << name << ": area "
              << verdict(std::abs(area - exact_area) < 1e-8) << ", box "
              << verdict(corners.first.distance(lower_corner) < 1e-12 &&
                         corners.second.distance(upper_corner) < 1e-12)
              << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  using dealii::Point;
  const double pi = dealii::numbers::PI;
  measure("box",
          "set Lower corner = 0.1, 0.2\n set Upper corner = 0.9, 0.7\n",
          0.8 * 0.5,
          Point<2>(0.1, 0.2),
          Point<2>(0.9, 0.7));
  measure("ball",
          "set Shape = ball\n set Centre = 1, 0.5\n set Radius = 0.4\n",
          pi * 0.4 * 0.4,
          Point<2>(0.6, 0.1),
          Point<2>(1.4, 0.9));
  measure("ellipsoid",
          "set Shape = ellipsoid\n set Centre = 1, 0.5\n"
          " set Semi-axes = 0.8, 0.4\n",
          pi * 0.8 * 0.4,
          Point<2>(0.2, 0.1),
          Point<2>(1.8, 0.9));
  measure("triangle",
          "set Shape = polygon\n set Vertices = 0 0, 1 0, 0 1\n",
          0.5,
          Point<2>(0., 0.),
          Point<2>(1., 1.));
  measure("polygon with a notch",
          "set Shape = polygon\n"
          "set Vertices = 0 0, 0 1, 0.5 0.5, 1 1, 1 0\n",
          0.75,
          Point<2>(0., 0.),
          Point<2>(1., 1.));
  measure("expression, box of the domain",
          "set Shape = expression\n set Expression = y - 0.5 + 0.1*cos(pi*x)\n",
          1.,
          Point<2>(0., 0.),
          Point<2>(2., 1.));

  for (const char *entries :
       {"set Lower corner = 0.1\n set Upper corner = 0.9, 0.7\n",
        "set Lower corner = 0.1, 0.8\n set Upper corner = 0.9, 0.7\n",
        "set Lower corner = 0.1, 0.2\n set Upper corner = 2.5, 0.7\n",
        "set Lower corner = 0.1, nan\n set Upper corner = 0.5, 0.7\n",
        "set Shape = ball\n set Centre = 1, 0.5\n set Radius = -1\n",
        "set Shape = ball\n set Centre = 1, 0.5\n set Radius = 0.6\n",
        "set Shape = polygon\n set Vertices = 0 0, 1 0\n",
        "set Shape = polygon\n set Vertices = 0 0, 1 1, 1 0, 0 0.5\n",
        "set Shape = expression\n set Expression = x, y\n",
        "set Shape = cube\n"})
    print_input_error([&]() {
      std::unique_ptr<SceneFromText<2>> scene;
      make(entries, scene);
    });
}
