// SPDX-License-Identifier: LGPL-2.1-or-later
// Mass of the rows of the weak form at walls over that of the hats between
// nodes: for degree 2 (1/6)/(1/4) a direction in the corners of cells,
// (4/6)/(1/2) in their middles, 1 where cells are multilinear; 1 for degree 1.
// In a full box, and below a free surface.
#include <seiche/grid/row_mass.h>

#include "problem_from_text.h"

namespace
{
  using namespace seiche;

  const MPI_Comm   communicator = MPI_COMM_WORLD;
  constexpr double h            = 0.2;

  /// The ratio of a node among quadratic cells.
  template <int dim>
  double
  expected(const dealii::Point<dim> &node)
  {
    double ratio = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      ratio *= std::lround(2. * node[d] / h) % 2 == 0 ? 2. / 3. : 4. / 3.;
    return ratio;
  }

  template <int dim>
  void
  test(const unsigned int degree, const std::string &fluid)
  {
    ProblemFromText<dim> problem(
      "subsection Formulation\n set Element degree = " +
      std::to_string(degree) + "\nend\nsubsection Grid\n set Lower corner = " +
      corner<dim>("0") + "\n set Upper corner = " + corner<dim>("1") +
      "\n set Cell size = 0.2\nend\n"
      "subsection Fluid body a\n set Lower corner = " +
      corner<dim>("0") + "\n set Upper corner = " + fluid + "\nend\n");
    Occupancy<dim> &occupancy = problem.occupancy;
    problem.find_cells();
    occupancy.set_linear(problem.fill.linear_cells());
    RowMass<dim> row_mass(occupancy, /*is_needed=*/true);
    row_mass.reinit(problem.points);

    GridState<dim> state;
    state.mass.reinit(occupancy.nodes.partitioner());
    state.mass           = 1.;
    unsigned int n_walls = 0, n_rows = 0, n_hats = 0;
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      if (occupancy.constraints.wall_components(node) != 0)
        {
          const double value = row_mass.value(state, node);
          const auto   x     = occupancy.nodes.position(node);
          ++n_walls;
          n_rows += std::abs(value - expected<dim>(x)) < 1e-12;
          n_hats += std::abs(value - 1.) < 1e-12;
        }
    const auto sum = [](const unsigned int n) {
      return dealii::Utilities::MPI::sum(n, communicator);
    };
    print(dim,
          "D, degree ",
          degree,
          ", fluid up to ",
          fluid,
          ": nodes at walls ",
          sum(n_walls),
          ", as quadratic cells have it ",
          sum(n_rows),
          ", as hats ",
          sum(n_hats));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      test<2>(degree, "1, 1");
      test<2>(degree, "1, 0.6");
      test<3>(degree, "1, 1, 1");
      test<3>(degree, "1, 1, 0.6");
    }
}
