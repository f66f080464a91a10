// SPDX-License-Identifier: LGPL-2.1-or-later
// Curved and inclined bodies: the points have the mass of the body, none is
// light, and the surface that follows from them is the body's, not a staircase.
// Same output on any number of ranks.
#include <seiche/grid/fill.h>

#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;
  using std::to_string;

  const double pi    = numbers::PI;
  const double slope = std::tan(10. * pi / 180.);

  /// What is known about a scene.
  template <int dim>
  struct Truth
  {
    double volume;
    double mass_error = 1e-9; // relative
    /// From the surface [m]; empty: not measured.
    std::function<double(const Point<dim> &)> distance = {};
    double                                    rms      = 0.; // of it [cells]
    bool                                      has_tips = false;
  };

  const char *
  verdict(const bool good)
  {
    return good ? "yes" : "NO";
  }

  /// Root mean square [cells] of the distances of the level set's zeros on the
  /// edges of cells that touch no wall.
  template <int dim>
  double
  distance_of_surface(const seiche::Fill<dim> &fill, const Truth<dim> &truth)
  {
    const auto &occupancy = fill.occupancy;
    const auto &locator   = occupancy.locator;
    double      sum = 0., n = 0.;
    for (unsigned int cell = 0; cell < locator.n_owned(); ++cell)
      {
        bool at_wall = false;
        for (const unsigned int f : GeometryInfo<dim>::face_indices())
          at_wall = at_wall || locator.boundary_id(cell, f) !=
                                 numbers::internal_face_boundary_id;
        if (at_wall || !occupancy.is_active(cell))
          continue;
        const auto level = [&](const unsigned int v) {
          return fill.surface().level_set().local_element(occupancy.cell_nodes(
            cell)[vertex_node<dim>(occupancy.fe.degree, v)]);
        };
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          for (unsigned int d = 0; d < dim; ++d)
            if (const unsigned int w = v | (1u << d);
                w != v && (level(v) < 0.) != (level(w) < 0.))
              {
                const double h = locator.geometry(cell).edges[d];
                Point<dim>   x = locator.geometry(cell).lower;
                for (unsigned int e = 0; e < dim; ++e)
                  x[e] += ((v >> e) & 1u) * h;
                x[d] += level(v) / (level(v) - level(w)) * h;
                sum += std::pow(truth.distance(x) / h, 2);
                n += 1.;
              }
      }
    return std::sqrt(Utilities::MPI::sum(sum, MPI_COMM_WORLD) /
                     Utilities::MPI::sum(n, MPI_COMM_WORLD));
  }

  /// Grid of cells of 0.05 (2D) or 0.1 m.
  template <int dim>
  std::string
  grid_text(const unsigned int per_direction)
  {
    return (dim == 2 ? "subsection Grid\n set Lower corner = 0, 0\n"
                       "set Upper corner = 2, 1\n set Cell size = 0.05\nend\n" :
                       "subsection Grid\n set Lower corner = 0, 0, 0\n"
                       "set Upper corner = 1, 1, 1\n set Cell size = 0.1\n"
                       "end\n") +
           ("subsection Points\n set Per cell and direction = " +
            to_string(per_direction) + "\nend\n");
  }

  std::string
  body(const std::string &shape, const std::string &name = "a")
  {
    return "subsection Fluid body " + name + "\n set Shape = " + shape +
           "\nend\n";
  }

  template <int dim>
  void
  check(const std::string &name,
        const std::string &bodies,
        const Truth<dim>  &truth)
  {
    const unsigned int          per = dim == 2 ? 3 : 2;
    const SceneFromText<dim>    scene(grid_text<dim>(per) + bodies);
    seiche::BackgroundGrid<dim> grid(scene.grid_parameters, MPI_COMM_WORLD);
    seiche::CellLocator<dim>    locator(grid);
    seiche::PointCloud<dim>     points(locator, {}, MPI_COMM_WORLD);
    const auto                  result = seiche::seed_bodies(scene.seeding,
                                            scene.bodies,
                                            scene.input,
                                            material_of_density(1.),
                                            points);

    double         mass = 0., lightest = 1.;
    Tensor<1, dim> checksum; // of ids and places
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const double m = points.data(seiche::PointColumn::mass)[p];
        mass += m;
        lightest = std::min(lightest, m);
        checksum +=
          m * (points.ids()[p] % 1009) * (points.position(p) - Point<dim>());
      }
    mass     = Utilities::MPI::sum(mass, MPI_COMM_WORLD);
    lightest = Utilities::MPI::min(lightest, MPI_COMM_WORLD);
    checksum = Utilities::MPI::sum(checksum, MPI_COMM_WORLD);
    std::set<std::uint64_t> ids;
    for (const auto &own :
         Utilities::MPI::all_gather(MPI_COMM_WORLD, points.ids()))
      ids.insert(own.begin(), own.end());

    const double       place = std::pow(2. * result.half_spacing, dim);
    std::ostringstream text;
    text << std::setprecision(8) << dim << "D " << name << ": mass "
         << verdict(std::abs(mass / truth.volume - 1.) < truth.mass_error);
    if (!truth.has_tips)
      text << ", none light " << verdict(lightest > 0.149 * place);
    if (truth.distance)
      {
        seiche::Occupancy<dim> occupancy(locator, 1);
        seiche::Fill<dim> fill(occupancy, seiche::QuadratureRule::cut_cells);
        occupancy.update(points);
        fill.update(points);
        const double distance = distance_of_surface(fill, truth);
        text << ", surface " << verdict(distance < truth.rms);
        if (distance >= truth.rms)
          text << " (off by " << distance << ")";
      }
    text << ", ids " << verdict(ids.size() == result.n_points) << "; points "
         << result.n_points << " checksum " << checksum;
    print(text.str());
    if (std::abs(mass / truth.volume - 1.) >= truth.mass_error)
      print("  relative error of the mass ", mass / truth.volume - 1.);
    if (!truth.has_tips && lightest <= 0.149 * place)
      print("  lightest ", lightest / place);
  }

  /// An expression whose surface follows the lattice makes the points of a box.
  void
  compare_with_box()
  {
    std::map<std::uint64_t, std::array<double, 3>> seeded[2];
    for (const bool box : {false, true})
      {
        const SceneFromText<2> scene(
          grid_text<2>(4) + "subsection Points\n set Jitter = 0.4\nend\n" +
          body(box ? "box\n set Lower corner = 0, 0\n"
                     "set Upper corner = 2, 0.5" :
                     "expression\n set Expression = y - 0.5"));
        seiche::BackgroundGrid<2> grid(scene.grid_parameters, MPI_COMM_WORLD);
        seiche::CellLocator<2>    locator(grid);
        seiche::PointCloud<2>     points(locator, {}, MPI_COMM_WORLD);
        seiche::seed_bodies(scene.seeding,
                            scene.bodies,
                            scene.input,
                            material_of_density(1.),
                            points);
        for (std::size_t p = 0; p < points.size(); ++p)
          seeded[box][points.ids()[p]] = {
            {points.position(p)[0],
             points.position(p)[1],
             points.data(seiche::PointColumn::initial_volume)[p]}};
      }
    print("flat expression, the points of a box: ",
          verdict(seeded[0] == seeded[1]));
  }

  std::string
  number(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
  }

  const std::string ramp = body("polygon\n set Vertices = 0 0, 2 0, 2 " +
                                number(0.313 + 2. * slope) + ", 0 0.313");
  const std::string ball_2d =
    body("ball\n set Centre = 0.93, 0.513\n set Radius = 0.41");
  const std::string ball_3d =
    body("ball\n set Centre = 0.53, 0.513, 0.49\n set Radius = 0.41");
  const std::string finer =
    "subsection Refinement fluid\n set Criterion = fluid\n set Level = 0\nend\n"
    "subsection Refinement part\n set Criterion = box\n set Level = 1\n";

  void
  check_2d()
  {
    const double volume = 2. * 0.313 + 2. * slope;
    check<2>("ramp, polygon",
             ramp,
             {volume,
              1e-9,
              [](const Point<2> &x) {
                return (x[1] - 0.313 - slope * x[0]) *
                       std::cos(std::atan(slope));
              },
              0.003});
    check<2>("ball",
             ball_2d,
             {pi * 0.41 * 0.41,
              1e-9,
              [](const Point<2> &x) {
                return x.distance(Point<2>(0.93, 0.513)) - 0.41;
              },
              0.012});
    check<2>("ellipse",
             body("ellipsoid\n set Centre = 0.93, 0.513\n"
                  "set Semi-axes = 0.81, 0.22"),
             {pi * 0.81 * 0.22});
    check<2>("wave, expression",
             body("expression\n"
                  "set Expression = y - 0.513 - 0.1*cos(2*pi*x)"),
             {2. * 0.513,
              1e-9,
              [](const Point<2> &x) {
                return (x[1] - 0.513 - 0.1 * std::cos(2. * pi * x[0])) /
                       std::hypot(1., 0.2 * pi * std::sin(2. * pi * x[0]));
              },
              0.012});
    check<2>("parallelogram, expression",
             body("expression\n set Expression = "
                  "max(abs(x-1+0.2*y) - 0.513, abs(y - 0.51)-0.2773)"),
             {4. * 0.513 * 0.2773, 1e-6});
    check<2>("star, polygon",
             body("polygon\n set Vertices = 0.2 0.2, 1 0.4, 1.8 0.21, "
                  "1.3 0.5, 1.77 0.9, 1.01 0.7, 0.21 0.9, 0.7 0.5"),
             {0.4445, 1e-6, {}, 0., true});
    check<2>("ramp around an obstacle",
             ramp + "subsection Obstacle a\n set Lower corner = 1, 0\n"
                    "set Upper corner = 1.2, 0.8\nend\n",
             {volume - 0.2 * (0.313 + 1.1 * slope)});
    check<2>("box around a ball",
             ball_2d + body("box\n set Lower corner = 0.21, 0.03\n"
                            "set Upper corner = 1.7, 0.97",
                            "b"),
             {1.49 * 0.94});
    const double half_angle = std::acos(0.25 / 0.41);
    check<2>("two balls",
             ball_2d + body("ball\n set Centre = 1.43, 0.513\n"
                            "set Radius = 0.41",
                            "b"),
             {0.41 * 0.41 *
                (2. * pi - 2. * half_angle + std::sin(2. * half_angle)),
              1e-6,
              {},
              0.,
              true});
    check<2>("ball, finer cells",
             finer +
               "set Lower corner = 0.5, 0.5\n"
               "set Upper corner = 1, 1\nend\n" +
               ball_2d,
             {pi * 0.41 * 0.41});
  }

  void
  check_3d()
  {
    const double area = 4. / 3. * pi;
    check<3>("ramp, expression",
             body("expression\n set Expression = z - 0.313 - 0.1*y - x*" +
                  number(slope)),
             {0.313 + 0.5 * slope + 0.05,
              1e-9,
              [](const Point<3> &x) {
                return (x[2] - 0.313 - slope * x[0] - 0.1 * x[1]) /
                       std::sqrt(1.01 + slope * slope);
              },
              0.01});
    check<3>("ball",
             ball_3d,
             {area * std::pow(0.41, 3),
              1e-9,
              [](const Point<3> &x) {
                return x.distance(Point<3>(0.53, 0.513, 0.49)) - 0.41;
              },
              0.04});
    check<3>("ramp, polygon",
             body("polygon\n set Vertices = 0 0, 1 0, 1 " +
                  number(0.313 + slope) + ", 0 0.313"),
             {0.313 + 0.5 * slope,
              1e-9,
              [](const Point<3> &x) {
                return (x[2] - 0.313 - slope * x[0]) *
                       std::cos(std::atan(slope));
              },
              0.01});
    check<3>("wedge, polygon with span",
             body("polygon\n set Vertices = 0.1 0.07, 0.9 0.07, 0.9 0.61\n"
                  "set Span = 0.23, 0.81"),
             {0.5 * 0.8 * 0.54 * 0.58, 1e-6, {}, 0., true});
    check<3>("ellipsoid",
             body("ellipsoid\n set Centre = 0.53, 0.513, 0.49\n"
                  "set Semi-axes = 0.43, 0.38, 0.21"),
             {area * 0.43 * 0.38 * 0.21});
    check<3>("cylinder, expression",
             body("expression\n set Expression = "
                  "max((x-0.53)^2+(z-0.49)^2-0.1681, abs(y-0.513)-0.333)"),
             {2. * 0.333 * pi * 0.1681, 1e-6});
    check<3>("box around a ball",
             ball_3d + body("box\n set Lower corner = 0.11, 0.07, 0.03\n"
                            "set Upper corner = 0.97, 0.95, 0.93",
                            "b"),
             {0.86 * 0.88 * 0.9, 1e-9});
    check<3>("ball, finer cells",
             finer +
               "set Lower corner = 0.5, 0.5, 0\n"
               "set Upper corner = 1, 1, 0.5\nend\n" +
               ball_3d,
             {area * std::pow(0.41, 3)});
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_2d();
  check_3d();
  compare_with_box();
}
