// SPDX-License-Identifier: LGPL-2.1-or-later
// Area of each shape, summed over boxes, and the refused bodies.
#include <seiche/scene/box_part.h>
#include <seiche/scene/fluid_body.h>

#include <iomanip>

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



  void
  measure(const std::string &entries)
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
    std::cout << "area " << area << " box " << corners.first << " to "
              << corners.second << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(9);

  measure("set Lower corner = 0.1, 0.2\n set Upper corner = 0.9, 0.7\n");
  measure("set Shape = ball\n set Centre = 1, 0.5\n set Radius = 0.4\n");
  measure("set Shape = ellipsoid\n set Centre = 1, 0.5\n"
          " set Semi-axes = 0.8, 0.4\n");
  measure("set Shape = polygon\n set Vertices = 0 0, 1 0, 0 1\n");
  measure("set Shape = polygon\n set Vertices = 0 0, 0 1, 0.5 0.5, 1 1, 1 0\n");
  measure(
    "set Shape = expression\n set Expression = y - 0.5 + 0.1*cos(pi*x)\n");

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
