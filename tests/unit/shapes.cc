// SPDX-License-Identifier: LGPL-2.1-or-later
// Of each shape: volume, summed over boxes; distance and normal; the box; what
// is refused.
#include <fstream>

#include "shape_checks.h"

namespace
{
  const double pi = dealii::numbers::PI;

  void
  test_solids()
  {
    test<2>("box",
            "set Lower corner = 0.1, 0.2\n set Upper corner = 0.9, 0.7\n",
            0.8 * 0.5,
            {0.1, 0.2},
            {0.9, 0.7});
    test<2>("ball",
            "set Shape = ball\n set Centre = 1, 0.5\n set Radius = 0.4\n",
            pi * 0.4 * 0.4,
            {0.6, 0.1},
            {1.4, 0.9});
    test<2>("ellipsoid",
            "set Shape = ellipsoid\n set Centre = 1, 0.5\n"
            " set Semi-axes = 0.8, 0.4\n",
            pi * 0.8 * 0.4,
            {0.2, 0.1},
            {1.8, 0.9});
    test<2>("half-space",
            "set Shape = half-space\n set Point = 1, 0.5\n"
            " set Normal = 1, 2\n",
            1.,
            {0., 0.},
            {2., 1.});
    test<2>("triangle",
            "set Shape = polygon\n set Vertices = 0 0, 1 0, 0 1\n",
            0.5,
            {0., 0.},
            {1., 1.});
    test<2>("polygon with a notch",
            "set Shape = polygon\n"
            "set Vertices = 0 0, 0 1, 0.5 0.5, 1 1, 1 0\n",
            0.75,
            {0., 0.},
            {1., 1.});
    test<2>("expression, box of the domain",
            "set Shape = expression\n"
            " set Expression = y - 0.5 + 0.1*cos(pi*x)\n",
            1.,
            {0., 0.},
            {2., 1.});
    test<3>("cylinder",
            "set Shape = cylinder\n set Ends = 0.5 0.5 0.5, 1.5 0.5 0.5\n"
            " set Radius = 0.3\n",
            pi * 0.09,
            {0.5, 0.2, 0.2},
            {1.5, 0.8, 0.8},
            1e-5);
    test<3>("half-space",
            "set Shape = half-space\n set Point = 1, 0.5, 0.5\n"
            " set Normal = -1, 0, 2\n",
            1.,
            {0., 0., 0.},
            {2., 1., 1.});
  }

  void
  test_height_maps()
  {
    std::ofstream("bed.csv") << "x, z\n0, 0.2\n# a ridge\n1, 0.4\n2, 0.2\n";
    test<2>("height map",
            "set Shape = height map\n set Heights = bed.csv\n",
            0.6,
            {0., 0.},
            {2., 0.4});
    std::ofstream("plane.csv") << "x, y, z\n0, 0, 0.2\n2, 0, 0.4\n"
                                  "0, 1, 0.4\n2, 1, 0.6\n";
    test<3>("height map",
            "set Shape = height map\n set Heights = plane.csv\n",
            0.8,
            {0., 0., 0.},
            {2., 1., 0.6});
    // the same plane, of cells of 1 m around the domain; the north comes first
    std::ofstream("plane.asc") << "ncols 4\nnrows 3\nxllcorner -1\n"
                                  "yllcorner -1\ncellsize 1\n"
                                  "NODATA_value -9999\n"
                                  "0.45 0.55 0.65 0.75\n"
                                  "0.25 0.35 0.45 0.55\n"
                                  "0.05 0.15 0.25 0.35\n";
    test<3>("ESRI grid",
            "set Shape = height map\n set Heights = plane.asc\n",
            0.8,
            {0., 0., 0.},
            {2., 1., 0.75});
    std::ofstream("hole.asc") << "ncols 2\nnrows 2\nxllcenter 0\n"
                                 "yllcenter 0\ncellsize 2\n"
                                 "NODATA_value -9999\n1 2\n3 -9999\n";
    refused<3>("set Shape = height map\n set Heights = hole.asc\n");
    std::ofstream("short.csv") << "x, z\n0, 0.2\n1.5, 0.4\n";
    refused<2>("set Shape = height map\n set Heights = short.csv\n");
    std::ofstream("ragged.csv") << "x, y, z\n0, 0, 1\n2, 0, 1\n0, 1, 1\n";
    refused<3>("set Shape = height map\n set Heights = ragged.csv\n");
    refused<2>("set Shape = height map\n set Heights = none.csv\n");
    refused<2>("set Shape = height map\n set Heights = plane.asc\n");
  }

  std::string
  shape_text(const std::string &name, const std::string &entries)
  {
    return "subsection Shape " + name + "\n" + entries + "end\n";
  }

  void
  test_composed()
  {
    const std::string left =
      shape_text("left",
                 "set Lower corner = 0.2, 0.2\n set Upper corner = 1, 0.8\n");
    const std::string right =
      shape_text("right",
                 "set Shape = ball\n set Centre = 1, 0.5\n set Radius = 0.2\n");
    const double half_ball = 0.5 * pi * 0.04;
    test<2>("union",
            "set Shape = union\n set Parts = left, right\n",
            0.48 + half_ball,
            {0.2, 0.2},
            {1.2, 0.8},
            1e-5,
            left + right);
    test<2>("intersection",
            "set Shape = intersection\n set Parts = left, right\n",
            half_ball,
            {0.8, 0.3},
            {1., 0.7},
            1e-5,
            left + right);
    test<2>("difference",
            "set Shape = difference\n set Parts = left, right\n",
            0.48 - half_ball,
            {0.2, 0.2},
            {1., 0.8},
            1e-5,
            left + right);
    // parts of parts
    test<2>("difference of a union",
            "set Shape = difference\n set Parts = both, hole\n",
            0.48 + half_ball - 0.01,
            {0.2, 0.2},
            {1.2, 0.8},
            1e-5,
            left + right +
              shape_text("both",
                         "set Shape = union\n set Parts = left, right\n") +
              shape_text("hole",
                         "set Lower corner = 0.4, 0.4\n"
                         " set Upper corner = 0.5, 0.5\n"));
    refused<2>("set Shape = union\n set Parts = left, wrong\n", left);
    refused<2>("set Shape = union\n", left);
  }

  void
  test_placed()
  {
    const double r = std::sqrt(0.5);
    test<2>("box turned by 45 degrees",
            "set Lower corner = 0.5, 0.25\n set Upper corner = 1, 0.75\n"
            " set Rotation = 45\n set Pivot = 0.75, 0.5\n set Shift = 0.1, 0\n",
            0.25,
            {0.85 - 0.5 * r, 0.5 - 0.5 * r},
            {0.85 + 0.5 * r, 0.5 + 0.5 * r},
            1e-5);
    test<2>("ball, twice as large",
            "set Shape = ball\n set Centre = 0.5, 0.25\n set Radius = 0.2\n"
            " set Scale = 2\n",
            pi * 0.16,
            {0.6, 0.1},
            {1.4, 0.9});
    // what is endless is so after it has been turned
    test<2>("turned half-space",
            "set Shape = half-space\n set Point = 1, 0.5\n set Normal = 0, 1\n"
            " set Rotation = 30\n set Pivot = 1, 0.5\n",
            1.,
            {0., 0.},
            {2., 1.});
    test<3>("upright cylinder",
            "set Shape = cylinder\n set Ends = 0 0 0, 0.5 0 0\n"
            " set Radius = 0.3\n set Rotation = 0, 1, 0, -90\n"
            " set Shift = 1, 0.5, 0.2\n",
            0.5 * pi * 0.09,
            {0.7, 0.2, 0.2},
            {1.3, 0.8, 0.7},
            1e-5);
    refused<2>("set Lower corner = 0, 0\n set Upper corner = 1, 1\n"
               " set Rotation = 1, 2\n");
    refused<3>("set Lower corner = 0, 0, 0\n set Upper corner = 1, 1, 1\n"
               " set Rotation = 0, 0, 0, 30\n");
    refused<2>("set Lower corner = 0, 0\n set Upper corner = 1, 1\n"
               " set Shift = 0.5, 0.5\n");
  }
} // namespace


int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_solids();
  test_height_maps();
  test_composed();
  test_placed();
  for (const char *entries :
       {"set Lower corner = 0.1\n set Upper corner = 0.9, 0.7\n",
        "set Lower corner = 0.1, 0.8\n set Upper corner = 0.9, 0.7\n",
        "set Lower corner = 0.1, 0.2\n set Upper corner = 2.5, 0.7\n",
        "set Lower corner = 0.1, nan\n set Upper corner = 0.5, 0.7\n",
        "set Shape = ball\n set Centre = 1, 0.5\n set Radius = -1\n",
        "set Shape = ball\n set Centre = 1, 0.5\n set Radius = 0.6\n",
        "set Shape = half-space\n set Point = 1, 0.5\n set Normal = 0, 0\n",
        "set Shape = polygon\n set Vertices = 0 0, 1 0\n",
        "set Shape = polygon\n set Vertices = 0 0, 1 1, 1 0, 0 0.5\n",
        "set Shape = expression\n set Expression = x, y\n",
        "set Shape = cube\n"})
    refused<2>(entries);
  refused<3>("set Shape = cylinder\n set Ends = 1 1 1, 1 1 1\n"
             " set Radius = 0.2\n");
}
