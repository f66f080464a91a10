// SPDX-License-Identifier: LGPL-2.1-or-later
// Walls: the normal is the gradient of the distance, a place moved back along
// it lies on the wall, and the velocity is the derivative of the way.
#include <seiche/mesh/cell_locator.h>
#include <seiche/shapes/solid_shapes.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;

  template <int dim>
  std::vector<Point<dim>>
  random_places(const double from, const double to)
  {
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> coordinate(from, to);
    std::vector<Point<dim>>                result(200);
    for (Point<dim> &x : result)
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = coordinate(random);
    return result;
  }

  /// Largest difference between the normal and the gradient of the distance.
  template <int dim, typename Distance, typename Normal>
  double
  error_of_normal(const Distance &distance, const Normal &normal)
  {
    constexpr double h     = 1e-6;
    double           error = 0.;
    for (const Point<dim> &x : random_places<dim>(-0.5, 2.5))
      {
        Tensor<1, dim> gradient;
        for (unsigned int d = 0; d < dim; ++d)
          {
            Point<dim> before = x, after = x;
            before[d] -= h;
            after[d] += h;
            gradient[d] = (distance(after) - distance(before)) / (2. * h);
          }
        error = std::max(error, (gradient - normal(x)).norm());
      }
    return error;
  }

  template <int dim>
  void
  test_shapes()
  {
    Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = 0.3 - 0.1 * d;
        upper[d] = 1. + 0.2 * d;
      }
    const BoundingBox<dim> extent({lower, upper});
    Tensor<1, dim>         radii;
    for (unsigned int d = 0; d < dim; ++d)
      radii[d] = 0.4;
    const auto disc =
      seiche::ellipsoid_shape<dim>(Point<dim>::unit_vector(0), radii);
    const auto box = seiche::box_shape<dim>(extent);
    const auto plane =
      seiche::half_space_shape<dim>(2. * Point<dim>::unit_vector(1),
                                    -1. * Point<dim>::unit_vector(1),
                                    extent);
    for (const auto &[name, shape] :
         {std::pair<const char *, const seiche::Shape<dim> *>{"disc",
                                                              disc.get()},
          {"box", box.get()},
          {"plane", plane.get()}})
      {
        double off = 0.;
        for (const Point<dim> &x : random_places<dim>(-0.5, 2.5))
          off = std::max(off,
                         std::abs(shape->distance(x - shape->distance(x) *
                                                        shape->normal(x))));
        print("  ",
              name,
              ": normal is the gradient of the distance ",
              verdict(error_of_normal<dim>(
                        [&](const auto &x) { return shape->distance(x); },
                        [&](const auto &x) { return shape->normal(x); }) <
                      1e-8),
              ", leads to the wall ",
              verdict(off < 1e-12));
      }
  }

  template <int dim>
  void
  test_walls()
  {
    std::string text = "subsection Grid\n"
                       "set Lower corner = " +
                       corner<dim>("0") +
                       "\nset Upper corner = " + corner<dim>("2") +
                       "\nset Cell size = 0.25\nend\n"
                       "subsection Walls\n"
                       "set Left displacement = 0.1*t^2\n"
                       "set Top = no-slip\n"
                       "set Top velocity = 3*t; 0" +
                       std::string(dim == 3 ? "; 0" : "") +
                       "\nend\n"
                       "subsection Obstacle block\n"
                       "set Lower corner = " +
                       corner<dim>("1") +
                       "\nset Upper corner = " + corner<dim>("1.5") + "\nend\n";
    const SceneFromText<dim> scene(text);
    const auto              &walls = scene.grid_parameters.walls;
    const auto &left = walls[0], &right = walls[1], &top = walls[2 * dim - 1],
               &block = walls[2 * dim];
    Point<dim> here;
    for (unsigned int d = 0; d < dim; ++d)
      here[d] = 0.25;
    const double t = 1.5, dt = 0.01;
    const auto   is = [](const double value, const double wanted) {
      return std::abs(value - wanted) < 1e-9;
    };
    print("  distances of sides, displaced or not ",
          verdict(is(left.distance(here, t), 0.25 - 0.1 * t * t) &&
                  is(right.distance(here, t), 1.75) &&
                  is(block.distance(here, t), 0.75 * std::sqrt(dim))));
    print("  a piston has the velocity of its way ",
          verdict(is(left.velocity(here, t, dt)[0], 0.2 * t) &&
                  is(left.velocity(here, t, dt).norm(), 0.2 * t)));
    print("  a belt its own ",
          verdict(is(top.velocity(here, t, dt)[0], 3. * t) &&
                  is(block.velocity(here, t, dt).norm(), 0.)));

    const seiche::BackgroundGrid<dim> grid(scene.grid_parameters,
                                           MPI_COMM_WORLD);
    const seiche::GridMotion<dim>     motion(scene.grid_parameters, 2.);
    seiche::CellLocator<dim>          locator(grid);
    Point<dim>                        behind = here, inside = here;
    behind[0] = 0.2;
    for (unsigned int d = 0; d < dim; ++d)
      inside[d] = 1.2;
    const bool before = locator.wall_beyond(behind) == nullptr &&
                        locator.find(behind) != locator.invalid;
    locator.move(motion, t);
    print("  a place the piston has passed is behind it ",
          verdict(before && locator.wall_beyond(behind) == &left &&
                  locator.find(behind) == locator.invalid &&
                  locator.wall_beyond(here) == nullptr &&
                  locator.wall_beyond(inside) == &block));
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  print("2D");
  test_shapes<2>();
  test_walls<2>();
  print("3D");
  test_shapes<3>();
  test_walls<3>();
}
