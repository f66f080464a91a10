// SPDX-License-Identifier: LGPL-2.1-or-later
// Points that swirl through the cells (and ranks): order, columns, outflow
// and the message for a lost point.
#include <cmath>

#include "global_reductions.h"
#include "scene_from_text.h"

namespace
{
  /// A number that tells a point from all others.
  double
  mark_of(const std::uint64_t id)
  {
    return 1. + double(id % 100003);
  }



  /// Of all ranks.
  struct Sums
  {
    std::uint64_t points = 0;
    double        mass   = 0.;
  };



  template <int dim, typename Condition>
  Sums
  sums_where(const seiche::PointCloud<dim> &points, const Condition &counts)
  {
    Sums result;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (counts(points.position(p)))
        {
          ++result.points;
          result.mass += points.data(seiche::PointColumn::mass)[p];
        }
    result.points = global_sum(result.points);
    result.mass   = global_sum(result.mass);
    return result;
  }



  /// @p gone: what has to have left of the points at the @p start.
  template <int dim>
  void
  report(const std::string             &name,
         const seiche::PointCloud<dim> &points,
         const Sums                    &start,
         const Sums                    &gone = {})
  {
    std::uint64_t n_unsorted = 0, n_mixed = 0, n_misplaced = 0, n_indexed = 0;
    for (unsigned int cell = 0; cell < points.locator.cells.n_owned(); ++cell)
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
          }
      }
    const Sums now = sums_where(points, [](const auto &) { return true; });
    print(dim,
          "D ",
          name,
          ": ",
          now.points,
          " points, of their cells ",
          verdict(global_sum(n_misplaced) == 0 &&
                  global_sum(n_indexed) == now.points),
          ", in order ",
          verdict(global_sum(n_unsorted) == 0),
          ", columns together ",
          verdict(global_sum(n_mixed) == 0),
          ", counted ",
          verdict(points.n_global() == now.points),
          ", left ",
          points.outflow.points,
          ", none else lost ",
          verdict(points.outflow.points == gone.points &&
                  now.points + gone.points == start.points),
          ", mass too ",
          verdict(std::abs(points.outflow.mass - gone.mass) < 1e-9 &&
                  std::abs(now.mass + gone.mass - start.mass) < 1e-9));
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
  test(const double mass, const std::string &text)
  {
    SeededScene<dim> seeded(text,
                            1000.,
                            {seiche::PointColumn::velocity_gradient});
    auto            &points = seeded.points;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        points.data(seiche::PointColumn::pressure)[p] =
          mark_of(points.ids()[p]);
        points.data(seiche::PointColumn::velocity_gradient, dim * dim - 1)[p] =
          -mark_of(points.ids()[p]);
      }
    const Sums start = {3840, mass};
    report("seeded", points, start);

    // a swirl that is zero at the walls, at most 0.9 cells a step
    for (unsigned int step = 0; step < 40; ++step)
      move(points, [](const dealii::Point<dim> &x, const unsigned int d) {
        const double pi = dealii::numbers::PI;
        return d == 0 ? 0.045 * std::sin(pi * x[0]) * std::cos(pi * x[1]) :
               d == 1 ? -0.045 * std::cos(pi * x[0]) * std::sin(pi * x[1]) :
                        0.;
      });
    report("swirled", points, start);
    move(points,
         [](const dealii::Point<dim> &, const unsigned int) { return 0.; });
    report("at rest", points, start);

    const Sums gone = sums_where(points, [](const dealii::Point<dim> &x) {
      return x[0] + 10 * 0.0377 > 1.;
    });
    for (unsigned int step = 0; step < 10; ++step)
      move(points, [](const dealii::Point<dim> &, const unsigned int d) {
        return d == 0 ? 0.0377 : 0.;
      });
    report("through the open side", points, start, gone);

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
        print("point ", all.substr(wall, all.find("; its last") - wall));
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(600.,
          "subsection Grid\n set Lower corner = 0, 0\n"
          "set Upper corner = 1, 1\n set Cell size = 0.05\nend\n"
          "subsection Walls\n set Right = open\nend\n"
          "subsection Fluid body a\n set Lower corner = 0, 0\n"
          "set Upper corner = 0.6, 1\nend\n"
          "subsection Points\n set Jitter = 0.4\nend\n");
  test<3>(60.,
          "subsection Grid\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 1, 1, 0.2\n set Cell size = 0.05\nend\n"
          "subsection Walls\n set Right = open\nend\n"
          "subsection Fluid body a\n set Lower corner = 0, 0, 0\n"
          "set Upper corner = 0.6, 1, 0.1\nend\n"
          "subsection Points\n set Per cell and direction = 2\nend\n");
}
