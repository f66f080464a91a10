// SPDX-License-Identifier: LGPL-2.1-or-later
// The free surface from the points' fill: a level anywhere in a cell is where
// it is, whatever the rows of points; the inside has their volume; cells with
// an inside but no points are occupied; a lone point stays a point. The same
// beside an obstacle that stands in the surface and on any number of ranks.

#include <cmath>
#include <map>

#include "problem_from_text.h"

namespace
{
  using namespace dealii;

  /// Water of a height in a tank 4 cells wide; with an obstacle that stands in
  /// its second column of cells.
  template <int dim>
  std::string
  tank(const double       height,
       const unsigned int per_direction,
       const bool         with_obstacle)
  {
    const std::string z = dim == 3 ? ", 0" : "", one = dim == 3 ? "0.4, " : "";
    return "subsection Grid\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 0.4, " + one +
           "1\n set Cell size = 0.1\nend\n" +
           (with_obstacle ?
              "subsection Obstacle post\n set Lower corner = 0.1, 0" + z +
                "\n set Upper corner = 0.2, " + one + "0.7\nend\n" :
              "") +
           "subsection Fluid body water\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 0.4, " + one + std::to_string(height) +
           "\nend\nsubsection Points\n set Per cell and direction = " +
           std::to_string(per_direction) + "\nend\n";
  }

  struct Result
  {
    double level, n_without_points;
  };

  /// Largest error of the height where the inside ends [cells], all points
  /// raised by @p rise [cells]: what they leave at the bottom does not count.
  template <int dim>
  Result
  find_surface(const unsigned int per_direction,
               const double       rise,
               const bool         with_obstacle)
  {
    constexpr double     height = 0.5, h = 0.1;
    ProblemFromText<dim> problem(
      tank<dim>(height, per_direction, with_obstacle));
    const seiche::CellLocator<dim> &locator   = problem.locator;
    const seiche::Occupancy<dim>   &occupancy = problem.occupancy;
    const seiche::Fill<dim>        &fill      = problem.fill;
    seiche::PointCloud<dim>        &points    = problem.points;
    double *y = points.data(seiche::PointColumn::position, dim - 1);
    for (std::size_t p = 0; p < points.size(); ++p)
      y[p] = std::max(y[p] + rise * h, 1e-6);
    points.locate();
    problem.find_cells();
    // of each column of cells, by the place of its lower corner
    using Tops = std::map<std::pair<double, double>, double>;
    Tops   of_rank, tops;
    double n_without_points = 0.;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const Point<dim> corner = locator.cells.geometry(cell).lower;
        if (corner[dim - 1] < height - 2.5 * h)
          continue;
        of_rank[{corner[0], dim == 3 ? corner[1] : 0.}] +=
          fill.surface().inside_share(cell);
        n_without_points += points.n_points_in(cell) == 0;
      }
    for (const Tops &some : Utilities::MPI::all_gather(MPI_COMM_WORLD, of_rank))
      for (const auto &[place, top] : some)
        tops[place] += top;
    double level = 0.;
    for (const auto &[place, top] : tops)
      level = std::max(level, std::abs(top - 2. - rise));
    AssertThrow(tops.size() == (with_obstacle ? 3 : 4) * (dim == 3 ? 4 : 1),
                ExcMessage("a column of cells has no fluid"));
    return {level, Utilities::MPI::sum(n_without_points, MPI_COMM_WORLD)};
  }

  template <int dim>
  void
  check_levels(const bool with_obstacle)
  {
    double level = 0., n_without_points = 0.;
    for (const unsigned int per_direction : {2, 4})
      for (const double rise : {-0.45, -0.2, -0.06, 0.03, 0.06, 0.11, 0.2, 0.4})
        {
          const Result result =
            find_surface<dim>(per_direction, rise, with_obstacle);
          level = std::max(level, result.level);
          n_without_points += result.n_without_points;
        }
    print(dim,
          "D",
          with_obstacle ? ", obstacle" : "",
          ", level within 0.002 cells: ",
          level < 0.002 ? "yes" : "NO",
          "; cells with an inside but no points are occupied: ",
          n_without_points > 0. ? "yes" : "NO");
    if (level >= 0.002)
      print("off by ", level);
  }

  /// A point alone in the air.
  template <int dim>
  void
  check_lone_point()
  {
    const std::string    z = dim == 3 ? "0.2, " : "";
    const std::string    w = dim == 3 ? "0.225, " : "";
    ProblemFromText<dim> problem(
      tank<dim>(0.5, 4, /*with_obstacle=*/false) +
      "subsection Fluid body drop\n set Lower corner = 0.2, " + z +
      "0.85\n set Upper corner = 0.225, " + w + "0.875\nend\n");
    const seiche::CellLocator<dim> &locator = problem.locator;
    const seiche::Fill<dim>        &fill    = problem.fill;
    const seiche::PointCloud<dim>  &points  = problem.points;
    problem.find_cells();
    double n_loose = 0., n_empty_cells = 0.;
    for (const unsigned int cell : problem.occupancy.cells.occupied())
      if (locator.cells.geometry(cell).lower[dim - 1] > 0.75)
        {
          const double *loose = fill.loose_shares(points, cell);
          n_loose += loose != nullptr && loose[0] == 1.;
          n_empty_cells += fill.surface().inside_share(cell) == 0.;
        }
    print(dim,
          "D, a lone point is loose: ",
          Utilities::MPI::sum(n_loose, MPI_COMM_WORLD) == 1. ? "yes" : "NO",
          ", its cell has no inside: ",
          Utilities::MPI::sum(n_empty_cells, MPI_COMM_WORLD) == 1. ? "yes" :
                                                                     "NO");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool with_obstacle : {false, true})
    {
      check_levels<2>(with_obstacle);
      check_levels<3>(with_obstacle);
    }
  check_lone_point<2>();
  check_lone_point<3>();
}
