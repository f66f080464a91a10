// SPDX-License-Identifier: LGPL-2.1-or-later
// A step that would carry a point through a wall is refused, with elements of
// both degrees, in 2D and 3D; one that puts it beside the wall, or through an
// open side, is not.
#include <seiche/transfer/transfer.h>

#include "scene_from_text.h"

namespace
{
  using namespace seiche;

  /// One point at 0.3 cells from the wall x = 0. The nodes at 0.5 cells (degree
  /// 2) or one cell (degree 1) move by @p way cells towards the wall.
  template <int dim>
  void
  test(const unsigned int degree, const double way, const char *condition)
  {
    const std::string        third = dim == 3 ? ", 0.3" : "";
    const SceneFromText<dim> scene(
      "subsection Grid\n set Lower corner = 0, 0" +
      std::string(dim == 3 ? ", 0" : "") + "\n set Upper corner = 2, 2" +
      (dim == 3 ? ", 2" : "") +
      "\n set Cell size = 1\nend\nsubsection Walls\n set Left = " + condition +
      "\nend\nsubsection Fluid body a\n set Lower corner = 0.1, 0.3" + third +
      "\n set Upper corner = 0.5, 0.7" + (dim == 3 ? ", 0.7" : "") +
      "\nend\nsubsection Points\n set Per cell and direction = 1\nend\n");
    BackgroundGrid<dim>      grid(scene.grid_parameters, MPI_COMM_WORLD);
    CellLocator<dim>         locator(grid);
    const TransferParameters parameters;
    PointCloud<dim>          points(locator,
                           Transfer<dim>::columns(parameters),
                           MPI_COMM_WORLD);
    seed_bodies(scene.seeding,
                scene.bodies,
                scene.input,
                material_of_density(1000.),
                points);
    Occupancy<dim> occupancy(locator, degree);
    occupancy.update(points);
    Fill<dim> fill(occupancy, QuadratureRule::cut_cells);
    fill.update(points);
    const auto               fluid = material_of_density(1000.);
    const CellMaterials<dim> materials(fluid, occupancy);
    const Transfer<dim>      transfer(parameters,
                                 fill,
                                 materials,
                                 VolumeUpdate::at_the_point);
    GridState<dim>           state;
    state.reinit(occupancy, true, false);
    state.dt = 1.;
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      if (std::abs(occupancy.nodes.position(node)[0] - 1. / degree) < 1e-10)
        state.displacement().local_element(dim * node) = -way;
    state.displacement().update_ghost_values();
    const StepCheck   check   = transfer.check(state, points, /*limit=*/1.);
    const std::string problem = check.problem(1., /*holds_points=*/false);
    print(dim,
          "D, degree ",
          degree,
          ", ",
          condition,
          ", way ",
          way,
          ": beyond the wall ",
          check.beyond_wall,
          "; ",
          problem.empty() ? "accepted" : problem);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const char *condition : {"slip", "open"})
    for (const double way : {0.3, 0.43})
      {
        test<2>(2, way, condition);
        test<3>(2, way, condition);
      }
  test<2>(1, 0.7, "slip");
  test<3>(1, 1.1, "slip");
}
