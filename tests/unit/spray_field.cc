// SPDX-License-Identifier: LGPL-2.1-or-later
// A drop flies past right above water whose highest cells hold none of its
// points: the field of the water goes on in these cells as if the drop were
// not there, and the drop keeps its velocity in its own cell.
#include <iostream>

#include "problem_from_text.h"

namespace
{
  using namespace dealii;
  using namespace seiche;

  template <int dim>
  std::string
  scene_text()
  {
    const std::string y = dim == 3 ? ", 0" : "", y1 = dim == 3 ? ", 0.3" : "";
    const std::string low = dim == 3 ? ", 0.12" : "",
                      up  = dim == 3 ? ", 0.14" : "";
    return "subsection Grid\n set Lower corner = 0" + y +
           ", 0\n set Upper corner = 0.5" + y1 +
           ", 0.6\n set Cell size = 0.1\nend\n"
           "subsection Fluid body water\n set Shape = box\n"
           " set Lower corner = 0" +
           y + ", 0\n set Upper corner = 0.5" + y1 +
           ", 0.325\n set Velocity = 0.2 + x" + (dim == 3 ? "; 0" : "") +
           "; -x\nend\nsubsection Fluid body drop\n set Shape = box\n"
           " set Lower corner = 0.21" +
           low + ", 0.41\n set Upper corner = 0.23" + up +
           ", 0.43\n set Velocity = 7" + (dim == 3 ? "; 0" : "") + "; 0\nend\n";
  }

  template <int dim>
  void
  test()
  {
    ProblemFromText<dim> problem(scene_text<dim>());
    GridState<dim>       state;
    // the fluid's uppermost points: a hair below the grid line at 0.3 m
    double *z = problem.points.data(PointColumn::position, dim - 1);
    for (std::size_t p = 0; p < problem.points.size(); ++p)
      if (z[p] > 0.3 && z[p] < 0.4)
        z[p] = 0.2999;
    problem.points.locate();
    problem.find_cells();
    problem.find_unknowns();
    problem.points_to_grid(state);
    const Occupancy<dim> &occupancy = problem.occupancy;
    const auto            velocity  = [&](const unsigned int node) {
      Tensor<1, dim> v;
      for (unsigned int d = 0; d < dim; ++d)
        v[d] = state.velocity_n.local_element(dim * node + d);
      return v;
    };
    unsigned int n_cells = 0;
    double       error = 0., kept = 0.;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const bool is_wet = problem.fill.surface().inside_share(cell) > 0.;
        const bool holds  = problem.points.n_points_in(cell) > 0;
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          {
            const unsigned int node = occupancy.nodes.of_cell(cell)[a];
            const Point<dim>   x    = occupancy.nodes.position(node);
            Tensor<1, dim>     water;
            water[0]       = 0.2 + x[0];
            water[dim - 1] = -x[0];
            if (is_wet && !holds)
              error = std::max(error, (velocity(node) - water).norm());
            if (!is_wet && x[dim - 1] > 0.45)
              kept = std::max(kept, std::abs(velocity(node)[0] - 7.));
          }
        n_cells += is_wet && !holds;
      }
    std::cout << dim << "D: cells of water without points "
              << (n_cells > 0 ? "some" : "NONE") << ", its field there "
              << (error < 1e-9 ? "goes on" :
                                 "is WRONG by " + std::to_string(error))
              << ", the drop's "
              << (kept < 1e-9 ? "is its own" :
                                "is WRONG by " + std::to_string(kept))
              << '\n';
  }
} // namespace

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
