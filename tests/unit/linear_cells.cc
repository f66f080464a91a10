// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements of degree 2 whose cells at the surface are multilinear, on an
// adaptive mesh: which cells are, fields stay continuous and keep linear
// functions, the two views of such a cell agree, its masses are positive. Same
// output on any number of ranks.

#include "problem_from_text.h"

namespace
{
  using namespace seiche;
  using dealii::Point;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  /// Fluid in a corner of a box; two levels, and a box that forces a level jump
  /// through the surface.
  template <int dim>
  std::string
  scene_text()
  {
    return "subsection Grid\n set Lower corner = " + corner<dim>("0") +
           "\n set Upper corner = " + corner<dim>("1.6") +
           "\n set Cell size = 0.2\nend\n"
           "subsection Fluid body a\n set Lower corner = " +
           corner<dim>("0") + "\n set Upper corner = " + corner<dim>("1") +
           "\nend\n"
           "subsection Formulation\n set Element degree = 2\nend\n"
           "subsection Points\n set Jitter = 0.3\n"
           "set Per cell and direction = 3\nend\n"
           "subsection Refinement fluid\n set Criterion = fluid\n"
           "set Level = 0\nend\n"
           "subsection Refinement probe\n set Criterion = box\n"
           "set Lower corner = " +
           corner<dim>("0.9") + "\n set Upper corner = " + corner<dim>("1.1") +
           "\n set Level = 1\nend\n";
  }

  template <int dim>
  using Nodal = typename Occupancy<dim>::Vector;

  /// Value of a field at a place in a cell, seen as of some degree.
  template <int dim, int degree>
  double
  value(const Occupancy<dim> &occupancy,
        const Nodal<dim>     &field,
        const unsigned int    cell,
        const Point<dim>     &x)
  {
    constexpr unsigned int n     = Basis<dim, degree>::n_nodes;
    const auto             nodes = occupancy.template unknowns<degree>(cell);
    double                 at[n], N[n], sum = 0.;
    for (unsigned int a = 0; a < n; ++a)
      at[a] = field.local_element(nodes[a]);
    nodes.expand(at);
    Basis<dim, degree>::values(
      occupancy.locator.cells.geometry(cell).to_unit(x), N);
    for (unsigned int a = 0; a < n; ++a)
      sum += N[a] * at[a];
    return sum;
  }

  /// @p f at some places of a unit cube, mapped to a cell or one of its faces.
  template <int dim, typename Function>
  void
  for_each_place(const CellLocator<dim> &locator,
                 const unsigned int      cell,
                 const unsigned int      face,
                 const Function         &f)
  {
    for (const double s : {0.2, 0.55, 0.9})
      for (const double t : {0.15, 0.6})
        {
          Point<dim> x = locator.cells.geometry(cell).lower;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += locator.cells.geometry(cell).edges[d] * (d == face / 2 ?
                                                               face % 2 :
                                                             d == 0 ? s :
                                                             d == 1 ? t :
                                                                      s * t);
          f(x);
        }
  }

  template <int dim>
  double
  linear(const Point<dim> &x)
  {
    return 1. + 2. * x[0] - 3. * x[1] + (dim == 3 ? 0.7 * x[dim - 1] : 0.);
  }

  template <int dim>
  double
  wild(const Point<dim> &x)
  {
    return std::sin(31. * x[0]) * std::cos(47. * x[1]) +
           std::sin(23. * x[dim - 1]);
  }

  template <int dim, typename Function>
  Nodal<dim>
  field_of(const Occupancy<dim> &occupancy, const Function &f)
  {
    Nodal<dim> result(occupancy.nodes.partitioner());
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      result.local_element(i) = f(occupancy.nodes.position(i));
    result.update_ghost_values();
    return result;
  }

  template <int dim>
  void
  test()
  {
    ProblemFromText<dim>    problem(scene_text<dim>());
    const CellLocator<dim> &locator   = problem.locator;
    Occupancy<dim>         &occupancy = problem.occupancy;
    problem.find_cells();
    occupancy.set_linear(problem.fill.linear_cells());

    const Nodal<dim> rough    = field_of<dim>(occupancy, wild<dim>);
    const Nodal<dim> smooth   = field_of<dim>(occupancy, linear<dim>);
    unsigned int     n_linear = 0, n_jumps = 0;
    double jump = 0., difference = 0., bend = 0., error = 0., least = 1.;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const bool is_linear = occupancy.degree(cell) == 1;
        n_linear += is_linear;
        for (const unsigned int face :
             dealii::GeometryInfo<dim>::face_indices())
          {
            const unsigned int other = locator.cells.neighbor(cell, face);
            if (other == locator.invalid ||
                !occupancy.cells.is_occupied(other) ||
                locator.cells.level(other) > locator.cells.level(cell))
              continue;
            n_jumps += locator.cells.level(other) < locator.cells.level(cell);
            for_each_place(locator, cell, face, [&](const Point<dim> &x) {
              jump =
                std::max(jump,
                         std::abs(value<dim, 2>(occupancy, rough, cell, x) -
                                  value<dim, 2>(occupancy, rough, other, x)));
            });
          }
        for_each_place(locator, cell, 2 * dim, [&](const Point<dim> &x) {
          const double two = value<dim, 2>(occupancy, rough, cell, x);
          error            = std::max(error,
                           std::abs(value<dim, 2>(occupancy, smooth, cell, x) -
                                    linear<dim>(x)));
          if (!is_linear)
            return;
          const double one = value<dim, 1>(occupancy, rough, cell, x);
          difference       = std::max(difference, std::abs(one - two));
          bend             = std::max(bend, std::abs(one - wild<dim>(x)));
          double N[Basis<dim, 1>::n_nodes];
          Basis<dim, 1>::values(locator.cells.geometry(cell).to_unit(x), N);
          occupancy.template unknowns<1>(cell).condense(N);
          least =
            std::min(least, *std::min_element(std::begin(N), std::end(N)));
        });
      }
    const auto sum = [](const unsigned int n) {
      return dealii::Utilities::MPI::sum(n, communicator);
    };
    const auto is_zero = [](const double v) {
      return dealii::Utilities::MPI::max(v, communicator) < 1e-12 ? "yes" :
                                                                    "no";
    };
    print(dim,
          "D: multilinear ",
          sum(n_linear),
          " of ",
          sum(occupancy.cells.occupied().size()),
          " cells, faces at level jumps ",
          sum(n_jumps));
    print("continuous: ",
          is_zero(jump),
          ", linear function kept: ",
          is_zero(error),
          ", both views agree: ",
          is_zero(difference),
          ", something to see: ",
          is_zero(bend) == std::string("no") ? "yes" : "no",
          ", positive: ",
          is_zero(-least));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
