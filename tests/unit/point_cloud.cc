// SPDX-License-Identifier: LGPL-2.1-or-later
// Points that swirl through the cells (and ranks): order, columns, outflow
// and the message for a lost point.
#include <cmath>
#include <iomanip>

#include "scene_from_text.h"

namespace
{
  const MPI_Comm communicator = MPI_COMM_WORLD;

  template <typename T>
  T
  global_sum(const T value)
  {
    return dealii::Utilities::MPI::sum(value, communicator);
  }



  /// A number that tells a point from all others.
  double
  mark_of(const std::uint64_t id)
  {
    return 1. + double(id % 100003);
  }



  template <int dim>
  void
  report(const std::string &name, const seiche::PointCloud<dim> &points)
  {
    std::uint64_t n_unsorted = 0, n_mixed = 0, n_misplaced = 0, n_indexed = 0;
    double        mass = 0.;
    for (unsigned int cell = 0; cell < points.locator.n_owned(); ++cell)
      {
        n_indexed += points.n_points_in(cell);
        for (const std::size_t p : points.points_in(cell))
          {
            n_misplaced += points.cells()[p] != cell ||
                           points.locator.find(points.position(p)) != cell;
            n_unsorted += p > points.first_point(cell) &&
                          points.ids()[p] <= points.ids()[p - 1];
            n_mixed +=
              points.data(seiche::PointColumn::pressure)[p] !=
                mark_of(points.ids()[p]) ||
              points.data(seiche::PointColumn::velocity_gradient,
                          dim * dim - 1)[p] != -mark_of(points.ids()[p]);
            mass += points.data(seiche::PointColumn::mass)[p];
          }
      }
    const auto n       = global_sum(n_indexed);
    const auto faults  = global_sum(n_unsorted + n_mixed + n_misplaced);
    const auto present = global_sum(std::uint64_t(points.size()));
    mass               = global_sum(mass);
    if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
      std::cout << name << ": points " << n << " counted " << points.n_global()
                << ' ' << present << " faults " << faults << " mass " << mass
                << " outflow " << points.n_outflow() << " of mass "
                << points.outflow_mass() << std::endl;
  }



  /// Displace every point; components by @p shift (position, direction).
  template <int dim, typename Shift>
  void
  move(seiche::PointCloud<dim> &points, const Shift &shift)
  {
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const dealii::Point<dim> x = points.position(p);
        for (unsigned int d = 0; d < dim; ++d)
          points.data(seiche::PointColumn::position, d)[p] += shift(x, d);
      }
    points.locate();
  }



  template <int dim>
  void
  test(const std::string &corner, const std::string &text)
  {
    const SceneFromText<dim>          scene(text);
    const seiche::BackgroundGrid<dim> grid(scene.grid_parameters, communicator);
    const seiche::CellLocator<dim>    locator(grid);
    seiche::PointCloud<dim>           points(locator,
                                   {seiche::PointColumn::velocity_gradient},
                                   communicator);
    seiche::seed_bodies(scene.seeding,
                        scene.bodies,
                        scene.input,
                        material_of_density(1000.),
                        points);
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        points.data(seiche::PointColumn::pressure)[p] =
          mark_of(points.ids()[p]);
        points.data(seiche::PointColumn::velocity_gradient, dim * dim - 1)[p] =
          -mark_of(points.ids()[p]);
      }
    report(std::to_string(dim) + "D " + corner, points);

    // a swirl that is zero at the walls, at most 0.9 cells a step
    for (unsigned int step = 0; step < 40; ++step)
      move(points, [](const dealii::Point<dim> &x, const unsigned int d) {
        const double pi = dealii::numbers::PI;
        return d == 0 ? 0.045 * std::sin(pi * x[0]) * std::cos(pi * x[1]) :
               d == 1 ? -0.045 * std::cos(pi * x[0]) * std::sin(pi * x[1]) :
                        0.;
      });
    report("swirled", points);
    move(points,
         [](const dealii::Point<dim> &, const unsigned int) { return 0.; });
    report("at rest", points);

    for (unsigned int step = 0; step < 10; ++step)
      move(points, [](const dealii::Point<dim> &, const unsigned int d) {
        return d == 0 ? 0.0377 : 0.;
      });
    report("through the open side", points);

    try
      {
        move(points, [](const dealii::Point<dim> &x, const unsigned int d) {
          return d == 1 && x[0] > 0.95 ? -0.049 - x[1] : 0.;
        });
      }
    catch (const seiche::NumericalError &error)
      {
        const std::string all  = error.what();
        const std::size_t wall = all.find("is lost");
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          std::cout << "point "
                    << all.substr(wall, all.find("; its last") - wall)
                    << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::cout << std::setprecision(10);
  test<2>("square",
          "subsection Grid\n set Lower corner = 0, 0\n"
          "set Upper corner = 1, 1\n set Cell size = 0.05\nend\n"
          "subsection Walls\n set Right = open\nend\n"
          "subsection Fluid body a\n set Lower corner = 0, 0\n"
          "set Upper corner = 0.6, 1\nend\n"
          "subsection Points\n set Jitter = 0.4\nend\n");
  test<3>("cube",
          "subsection Grid\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 1, 1, 0.2\n set Cell size = 0.05\nend\n"
          "subsection Walls\n set Right = open\nend\n"
          "subsection Fluid body a\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 0.6, 1, 0.1\nend\n"
          "subsection Points\n set Per cell and direction = 2\nend\n");
}
