// SPDX-License-Identifier: LGPL-2.1-or-later
// Curved and inclined bodies: the points have their mass and centre, none is
// light, and the surface that follows from them is the body's, not a staircase.
// Several ranks make the points of one.
#include <seiche/grid/fill.h>

#include <cmath>
#include <iomanip>
#include <map>
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
    double     volume;
    Point<dim> centre;
    double     error = 1e-9; // relative, and of the centre [m]
    /// From the surface [m]; empty: not measured.
    std::function<double(const Point<dim> &)> distance = {};
    double                                    rms      = 0.; // of it [cells]
    bool                                      has_tips = false;
  };

  /// Root mean square [cells] of the distances of the level set's zeros on the
  /// edges of cells that touch no wall.
  template <int dim>
  double
  distance_of_surface(const seiche::Fill<dim> &fill, const Truth<dim> &truth)
  {
    const auto &occupancy = fill.occupancy;
    const auto &locator   = occupancy.locator;
    double      sum = 0., n = 0.;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        bool at_wall = false;
        for (const unsigned int f : GeometryInfo<dim>::face_indices())
          at_wall = at_wall || locator.cells.wall_at(cell, f);
        if (at_wall || !occupancy.cells.is_active(cell))
          continue;
        const auto level = [&](const unsigned int v) {
          return fill.surface().level_set().local_element(
            occupancy.nodes.of_cell(
              cell)[seiche::vertex_node<dim>(occupancy.fe.degree, v)]);
        };
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          for (unsigned int d = 0; d < dim; ++d)
            if (const unsigned int w = v | (1u << d);
                w != v && (level(v) < 0.) != (level(w) < 0.))
              {
                const double h = locator.cells.geometry(cell).edges[d];
                Point<dim>   x = locator.cells.geometry(cell).lower;
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

  /// Place and volume of the points of this rank, by id.
  template <int dim>
  std::map<std::uint64_t, std::pair<Point<dim>, double>>
  by_id(const seiche::PointCloud<dim> &points)
  {
    std::map<std::uint64_t, std::pair<Point<dim>, double>> result;
    for (std::size_t p = 0; p < points.size(); ++p)
      result[points.ids()[p]] = {points.position(p),
                                 points.data(
                                   seiche::PointColumn::initial_volume)[p]};
    return result;
  }

  /// Whether the points of all ranks are those that one rank makes by itself.
  template <int dim>
  bool
  is_as_on_one_rank(const std::string &text, const SeededScene<dim> &shared)
  {
    const SeededScene<dim> alone(text, 1., {}, MPI_COMM_SELF);
    const auto             all   = by_id(alone.points);
    bool                   right = all.size() == alone.points.size() &&
                 shared.points.n_global() == alone.points.size();
    for (const auto &[id, point] : by_id(shared.points))
      right &= all.count(id) > 0 && all.at(id) == point;
    return Utilities::MPI::min(right ? 1 : 0, MPI_COMM_WORLD) == 1;
  }

  template <int dim>
  void
  check(const std::string &name,
        const std::string &bodies,
        const Truth<dim>  &truth)
  {
    const std::string      text = grid_text<dim>(dim == 2 ? 3 : 2) + bodies;
    const SeededScene<dim> seeded(text, 1.);
    const auto            &points = seeded.points;

    double         mass = 0., lightest = 1.;
    Tensor<1, dim> centre;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const double m = points.data(seiche::PointColumn::mass)[p];
        mass += m;
        lightest = std::min(lightest, m);
        centre += m * points.position(p);
      }
    mass     = Utilities::MPI::sum(mass, MPI_COMM_WORLD);
    lightest = Utilities::MPI::min(lightest, MPI_COMM_WORLD);
    centre   = Utilities::MPI::sum(centre, MPI_COMM_WORLD) / mass;

    const double       place = std::pow(2. * seeded.result.half_spacing, dim);
    const double       off   = truth.centre.distance(Point<dim>(centre));
    std::ostringstream line;
    line << dim << "D " << name << ": mass "
         << verdict(std::abs(mass / truth.volume - 1.) < truth.error)
         << ", centre " << verdict(off < truth.error);
    if (!truth.has_tips)
      line << ", none light " << verdict(lightest > 0.149 * place);
    if (truth.distance)
      {
        seiche::Occupancy<dim> occupancy(seeded.locator, 1);
        seiche::Fill<dim> fill(occupancy, seiche::QuadratureRule::cut_cells);
        occupancy.update(points);
        fill.update(points);
        const double distance = distance_of_surface(fill, truth);
        line << ", surface " << verdict(distance < truth.rms);
        if (distance >= truth.rms)
          line << " (off by " << distance << ")";
      }
    line << ", " << seeded.result.n_points << " points, as on one rank "
         << verdict(is_as_on_one_rank(text, seeded));
    print(line.str());
    if (std::abs(mass / truth.volume - 1.) >= truth.error)
      print("  relative error of the mass ", mass / truth.volume - 1.);
    if (!truth.has_tips && lightest <= 0.149 * place)
      print("  lightest ", lightest / place);
  }

  /// An expression whose surface follows the lattice makes the points of a box.
  void
  compare_with_box()
  {
    const auto seeded = [](const std::string &shape) {
      return by_id(
        SeededScene<2>(grid_text<2>(4) +
                         "subsection Points\n set Jitter = 0.4\nend\n" +
                         body(shape),
                       1.)
          .points);
    };
    const bool same =
      seeded("expression\n set Expression = y - 0.5") ==
      seeded("box\n set Lower corner = 0, 0\n set Upper corner = 2, 0.5");
    print("flat expression, the points of a box: ", verdict(same));
  }

  std::string
  number(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return text.str();
  }

  /// Area and centre.
  Truth<2>
  truth_of_polygon(const std::vector<Point<2>> &corners)
  {
    double       area = 0.;
    Tensor<1, 2> sum;
    for (unsigned int i = 0; i < corners.size(); ++i)
      {
        const auto  &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double twice = a[0] * b[1] - a[1] * b[0];
        area += 0.5 * twice;
        sum += twice / 6. * (Tensor<1, 2>(a) + b);
      }
    return {area, Point<2>(sum / area)};
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
    const auto height = [](const double x) { return 0.313 + slope * x; };
    const auto whole =
      truth_of_polygon({{0., 0.}, {2., 0.}, {2., height(2.)}, {0., 0.313}});
    const Point<2> ball(0.93, 0.513);
    check<2>("ramp, polygon",
             ramp,
             {whole.volume,
              whole.centre,
              1e-9,
              [](const Point<2> &x) {
                return (x[1] - 0.313 - slope * x[0]) *
                       std::cos(std::atan(slope));
              },
              0.003});
    check<2>("ball",
             ball_2d,
             {pi * 0.41 * 0.41,
              ball,
              1e-9,
              [](const Point<2> &x) {
                return x.distance(Point<2>(0.93, 0.513)) - 0.41;
              },
              0.012});
    check<2>("ellipse",
             body("ellipsoid\n set Centre = 0.93, 0.513\n"
                  "set Semi-axes = 0.81, 0.22"),
             {pi * 0.81 * 0.22, ball});
    check<2>("wave, expression",
             body("expression\n"
                  "set Expression = y - 0.513 - 0.1*cos(2*pi*x)"),
             {2. * 0.513,
              Point<2>(1., (0.513 * 0.513 + 0.005) / (2. * 0.513)),
              1e-9,
              [](const Point<2> &x) {
                return (x[1] - 0.513 - 0.1 * std::cos(2. * pi * x[0])) /
                       std::hypot(1., 0.2 * pi * std::sin(2. * pi * x[0]));
              },
              0.012});
    check<2>("parallelogram, expression",
             body("expression\n set Expression = "
                  "max(abs(x-1+0.2*y) - 0.513, abs(y - 0.51)-0.2773)"),
             {4. * 0.513 * 0.2773, Point<2>(1. - 0.2 * 0.51, 0.51), 1e-6});
    auto star     = truth_of_polygon({{0.2, 0.2},
                                      {1., 0.4},
                                      {1.8, 0.21},
                                      {1.3, 0.5},
                                      {1.77, 0.9},
                                      {1.01, 0.7},
                                      {0.21, 0.9},
                                      {0.7, 0.5}});
    star.error    = 1e-6;
    star.has_tips = true;
    check<2>("star, polygon",
             body("polygon\n set Vertices = 0.2 0.2, 1 0.4, 1.8 0.21, "
                  "1.3 0.5, 1.77 0.9, 1.01 0.7, 0.21 0.9, 0.7 0.5"),
             star);
    check<2>("ramp around an obstacle",
             ramp + "subsection Obstacle a\n set Lower corner = 1, 0\n"
                    "set Upper corner = 1.2, 0.8\nend\n",
             truth_of_polygon({{0., 0.},
                               {1., 0.},
                               {1., height(1.)},
                               {1.2, height(1.2)},
                               {1.2, 0.},
                               {2., 0.},
                               {2., height(2.)},
                               {0., 0.313}}));
    check<2>("box around a ball",
             ball_2d + body("box\n set Lower corner = 0.21, 0.03\n"
                            "set Upper corner = 1.7, 0.97",
                            "b"),
             {1.49 * 0.94, Point<2>(0.5 * 1.91, 0.5)});
    const double half_angle = std::acos(0.25 / 0.41);
    check<2>("two balls",
             ball_2d + body("ball\n set Centre = 1.43, 0.513\n"
                            "set Radius = 0.41",
                            "b"),
             {0.41 * 0.41 *
                (2. * pi - 2. * half_angle + std::sin(2. * half_angle)),
              Point<2>(1.18, 0.513),
              1e-6,
              {},
              0.,
              true});
    check<2>("ball, finer cells",
             finer +
               "set Lower corner = 0.5, 0.5\n"
               "set Upper corner = 1, 1\nend\n" +
               ball_2d,
             {pi * 0.41 * 0.41, ball});
  }

  void
  check_3d()
  {
    const double   area = 4. / 3. * pi;
    const Point<3> ball(0.53, 0.513, 0.49);
    const double   mean = 0.313 + 0.05 + 0.5 * slope; // height of the ramp
    check<3>("ramp, expression",
             body("expression\n set Expression = z - 0.313 - 0.1*y - x*" +
                  number(slope)),
             {mean,
              Point<3>(0.5 + slope / 12. / mean,
                       0.5 + 0.1 / 12. / mean,
                       0.5 * mean + 0.5 * (slope * slope + 0.01) / 12. / mean),
              1e-9,
              [](const Point<3> &x) {
                return (x[2] - 0.313 - slope * x[0] - 0.1 * x[1]) /
                       std::sqrt(1.01 + slope * slope);
              },
              0.01});
    check<3>("ball",
             ball_3d,
             {area * std::pow(0.41, 3),
              ball,
              1e-9,
              [](const Point<3> &x) {
                return x.distance(Point<3>(0.53, 0.513, 0.49)) - 0.41;
              },
              0.04});
    const auto below =
      truth_of_polygon({{0., 0.}, {1., 0.}, {1., 0.313 + slope}, {0., 0.313}});
    check<3>("ramp, polygon",
             body("polygon\n set Vertices = 0 0, 1 0, 1 " +
                  number(0.313 + slope) + ", 0 0.313"),
             {below.volume,
              Point<3>(below.centre[0], 0.5, below.centre[1]),
              1e-9,
              [](const Point<3> &x) {
                return (x[2] - 0.313 - slope * x[0]) *
                       std::cos(std::atan(slope));
              },
              0.01});
    check<3>("wedge, polygon with span",
             body("polygon\n set Vertices = 0.1 0.07, 0.9 0.07, 0.9 0.61\n"
                  "set Span = 0.23, 0.81"),
             {0.5 * 0.8 * 0.54 * 0.58,
              Point<3>(1.9 / 3., 0.52, 0.25),
              1e-6,
              {},
              0.,
              true});
    check<3>("ellipsoid",
             body("ellipsoid\n set Centre = 0.53, 0.513, 0.49\n"
                  "set Semi-axes = 0.43, 0.38, 0.21"),
             {area * 0.43 * 0.38 * 0.21, ball});
    check<3>("cylinder, expression",
             body("expression\n set Expression = "
                  "max((x-0.53)^2+(z-0.49)^2-0.1681, abs(y-0.513)-0.333)"),
             {2. * 0.333 * pi * 0.1681, ball, 1e-6});
    check<3>("box around a ball",
             ball_3d + body("box\n set Lower corner = 0.11, 0.07, 0.03\n"
                            "set Upper corner = 0.97, 0.95, 0.93",
                            "b"),
             {0.86 * 0.88 * 0.9, Point<3>(0.54, 0.51, 0.48)});
    check<3>("ball, finer cells",
             finer +
               "set Lower corner = 0.5, 0.5, 0\n"
               "set Upper corner = 1, 1, 0.5\nend\n" +
               ball_3d,
             {area * std::pow(0.41, 3), ball});
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
