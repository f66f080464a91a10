// SPDX-License-Identifier: LGPL-2.1-or-later
// Location of random points and of points on lines and walls, against a
// search through all cells.
#include <seiche/mesh/cell_locator.h>

#include <random>

#include "scene_from_text.h"

namespace
{
  /// The cell that holds x; on the upper side of the fluid domain the one
  /// below, of which there is one only because x[1] and x[2] are random.
  template <int dim>
  unsigned int
  brute_force(const seiche::CellLocator<dim> &locator,
              const dealii::Point<dim>       &x)
  {
    unsigned int touched = locator.invalid;
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      if (locator.cells.geometry(cell).holds(x))
        return cell;
      else if (locator.cells.geometry(cell).box().point_inside(
                 x, /*tolerance=*/0.))
        touched = cell;
    return touched;
  }



  template <int dim>
  void
  compare(const std::string &text)
  {
    const SceneFromText<dim>          scene(text);
    const seiche::BackgroundGrid<dim> grid(scene.grid_parameters,
                                           MPI_COMM_WORLD);
    const seiche::CellLocator<dim>    locator(grid);
    const auto                        box = scene.grid_parameters.domain();

    std::mt19937                           random(1);
    std::uniform_real_distribution<double> share(-0.05, 1.05);
    unsigned int n_wrong = 0, n_wrong_hint = 0, n_outside = 0, n_geometry = 0;
    unsigned int last = 0;
    for (unsigned int i = 0; i < 5000; ++i)
      {
        dealii::Point<dim> x;
        for (unsigned int d = 0; d < dim; ++d)
          x[d] = box.lower_bound(d) + share(random) * box.side_length(d);
        if (i % 2 == 0) // on a grid line
          x[0] = locator.cells.geometry(i % locator.cells.size()).lower[0];
        const unsigned int wanted = brute_force(locator, x);
        const unsigned int found  = locator.find(x);
        n_wrong += found != wanted;
        n_wrong_hint += locator.find(x, last) != wanted;
        n_outside += found == locator.invalid;
        if (found != locator.invalid)
          {
            last = found;
            n_geometry +=
              locator.cells.index(locator.cells.iterator(found)) != found ||
              std::abs(locator.cells.iterator(found)->measure() /
                         locator.cells.geometry(found).measure -
                       1.) > 1e-10;
          }
      }
    std::cout << dim << "D, " << locator.cells.size()
              << " cells, found as by search: " << verdict(n_wrong == 0)
              << ", with a hint: " << verdict(n_wrong_hint == 0)
              << ", those of the mesh: " << verdict(n_geometry == 0)
              << ", some outside: " << verdict(n_outside > 0);

    // neighbours across faces share that face
    unsigned int n_bad = 0, n_walls = 0;
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      for (unsigned int face = 0; face < 2 * dim; ++face)
        {
          const unsigned int other = locator.cells.neighbor(cell, face);
          if (other == locator.invalid)
            ++n_walls;
          else
            n_bad +=
              locator.cells.neighbor(other, face ^ 1u) != cell ||
              (face % 2 == 0 ? locator.cells.geometry(cell).lower[face / 2] !=
                                 locator.cells.geometry(other).upper[face / 2] :
                               locator.cells.geometry(cell).upper[face / 2] !=
                                 locator.cells.geometry(other).lower[face / 2]);
        }
    std::cout << ", neighbours share faces: " << verdict(n_bad == 0) << ", "
              << n_walls << " faces at walls" << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::string tank = "subsection Grid\n set Lower corner = 0, 0\n"
                           "set Upper corner = 3.22, 3.0\n"
                           "set Break points x = 1.2\n set Cells x = 24, 40\n"
                           "set Cells y = 60\nend\n";
  const std::string weir = "subsection Obstacle weir\n"
                           "set Lower corner = 1.61, 0\n"
                           "set Upper corner = 2.02, 0.5\nend\n";
  compare<2>(tank);
  compare<2>(tank + weir);
  compare<3>("subsection Grid\n set Lower corner = -1, 0, 0\n"
             "set Upper corner = 1, 1, 1\n set Cell size = 0.125\nend\n"
             "subsection Obstacle post\n set Lower corner = -0.25, 0.25, 0\n"
             "set Upper corner = 0.25, 0.75, 1\nend\n");

  // walls of the box and of the obstacle, up to round-off: in the cell that a
  // short way inwards leads into
  const SceneFromText<2>          scene(tank + weir);
  const seiche::BackgroundGrid<2> grid(scene.grid_parameters, MPI_COMM_WORLD);
  const seiche::CellLocator<2>    locator(grid);
  using dealii::Point;
  const double                                     tiny     = 1e-13;
  const std::vector<std::pair<Point<2>, Point<2>>> at_walls = {
    {Point<2>(0., 0.), Point<2>(1., 1.)},
    {Point<2>(3.22, 3.), Point<2>(-1., -1.)},
    {Point<2>(-tiny, 1.), Point<2>(1., 1.)},
    {Point<2>(3.22 + tiny, 3. + tiny), Point<2>(-1., -1.)},
    {Point<2>(1.61, 0.2), Point<2>(-1., 1.)},
    {Point<2>(1.61 + tiny, 0.2), Point<2>(-1., 1.)},
    {Point<2>(2.02 - tiny, 0.2), Point<2>(1., 1.)},
    {Point<2>(2.02, 0.2), Point<2>(1., 1.)},
    {Point<2>(1.8, 0.5), Point<2>(0., 1.)},
    {Point<2>(1.8, 0.5 - tiny), Point<2>(0., 1.)},
    {Point<2>(1.61 + tiny, 0.5 - tiny), Point<2>(-1., -1.)}};
  unsigned int n_right = 0;
  for (const auto &[x, inwards] : at_walls)
    n_right +=
      locator.find(x) == brute_force(locator, Point<2>(x + 1e-9 * inwards));
  std::cout << "at walls and corners, up to round-off: " << n_right << " of "
            << at_walls.size() << " in the cell inside" << std::endl;
  for (const auto &x : {Point<2>(-1e-6, 1.), Point<2>(1.8, 0.3)})
    std::cout << x << ": "
              << (locator.find(x) == locator.invalid ? "outside" : "INSIDE")
              << ", wall " << locator.wall_beyond(x)->name << std::endl;
}
