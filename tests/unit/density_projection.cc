// SPDX-License-Identifier: LGPL-2.1-or-later
// A bed that leaves next to nothing of a cell, and a point that lies a little
// in the bed there: it fills a hat without bounds, and is not sent away for
// that.
#include <algorithm>
#include <cmath>
#include <vector>

#include "problem_from_text.h"

namespace
{
  using namespace dealii;
  using namespace seiche;

  /// A box full of water but for its top; the bed rises by 1:20 and passes a
  /// grid line at @p x [m].
  template <int dim>
  std::string
  scene_text(const std::string &x)
  {
    const std::string y = dim == 3 ? ", 0" : "", y1 = dim == 3 ? ", 0.3" : "";
    return "subsection Grid\n set Lower corner = 0" + y +
           ", -0.1\n set Upper corner = 0.5" + y1 +
           ", 0.4\n set Cells x = 5\n set Cells y = " +
           (dim == 3 ? "3\n set Cells z = 5" : "5") +
           "\nend\nsubsection Solid bed\n set Shape = half-space\n"
           " set Point = " +
           x + y + ", 0\n set Normal = -0.04993762" + y +
           ", 0.99875234\nend\nsubsection Fluid body water\n set Lower corner = 0" +
           y + ", -0.1\n set Upper corner = 0.5" + y1 +
           ", 0.3\nend\nsubsection Points\n set Per cell and direction = 2"
           "\nend\n";
  }

  template <int dim>
  std::vector<Point<dim>>
  places(const PointCloud<dim> &points)
  {
    std::vector<Point<dim>> result;
    for (std::size_t p = 0; p < points.size(); ++p)
      result.push_back(points.position(p));
    return result;
  }

  /// Longest way of a point [cells].
  template <int dim>
  double
  longest_way(const std::string &x)
  {
    ProblemFromText<dim> problem(scene_text<dim>(x));
    PointCloud<dim>     &points  = problem.points;
    std::size_t          strayed = 0;
    Point<dim>           there;
    there[0]       = 0.25;
    there[1]       = 0.15;
    there[dim - 1] = -0.001;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (points.position(p).distance(there) <
          points.position(strayed).distance(there))
        strayed = p;
    for (unsigned int d = 0; d < dim; ++d)
      points.data(PointColumn::position, d)[strayed] = there[d];
    problem.find_cells();
    const std::vector<Point<dim>> before = places(points);
    problem.density_projection.apply(1., problem.grid_motion.box(0.), points);
    const std::vector<Point<dim>> after = places(points);
    double                        way   = 0.;
    for (std::size_t p = 0; p < before.size(); ++p)
      way = std::max(way, (after[p] - before[p]).norm() / 0.1);
    return way;
  }

  template <int dim>
  void
  test()
  {
    for (const std::string x : {"0.21", "0.2005", "0.2001"})
      {
        const double way = longest_way<dim>(x);
        std::cout << dim << "D, a sliver from 0.2 to " << x << " m: "
                  << (way < 0.05 ? "all stay" :
                                   "SENT AWAY by " + std::to_string(way))
                  << '\n';
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
