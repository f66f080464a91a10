// SPDX-License-Identifier: LGPL-2.1-or-later
// Inertia of the points' own extent: with that of the points it is the exact
// one of the fluid in a cell, full or not; uniform accelerations do not feel
// it; its tangent is the residual's derivative.
#include <seiche/formulation/point_inertia_term.h>
#include <seiche/formulation/term_list.h>

#include <cmath>

#include "problem_from_text.h"

namespace
{
  using namespace dealii;

  /// Two columns of cells, of which the left one is full up to 1.5 cells.
  template <int dim>
  std::string
  scene_text(const unsigned int per_direction)
  {
    const std::string z = dim == 3 ? ", 0" : "", z1 = dim == 3 ? ", 0.4" : "";
    return "subsection Grid\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 1, 1.2" + z1 +
           "\n set Break points x = 0.5\n set Cells x = 1, 1\n"
           " set Cells y = 3\n" +
           (dim == 3 ? " set Cells z = 1\n" : "") +
           "end\nsubsection Fluid body block\n set Lower corner = 0, 0" + z +
           "\n set Upper corner = 0.5, 0.6" + z1 +
           "\nend\nsubsection Quadrature\n set Rule = material points"
           "\nend\nsubsection Points\n set Per cell and direction = " +
           std::to_string(per_direction) + "\nend\n";
  }

  /// Largest error, over the cell's own one, of the second moment of the fluid
  /// in x and y; Gauss points do not count.
  template <int dim>
  double
  moment_error(const unsigned int per_direction, double &own_share)
  {
    ProblemFromText<dim>            problem(scene_text<dim>(per_direction));
    const seiche::CellLocator<dim> &locator   = problem.locator;
    const seiche::Occupancy<dim>   &occupancy = problem.occupancy;
    const seiche::Fill<dim>        &fill      = problem.fill;
    const seiche::PointCloud<dim>  &points    = problem.points;
    problem.find_cells();
    double error = 0.;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const double share = fill.cell_fill(cell); // the lower part
        for (unsigned int d = 0; d < 2; ++d)
          {
            const double height = d == 1 ? share : 1.;
            const double exact  = share * height * height / 12.;
            double       moment = fill.extent_moment(cell);
            for (const std::size_t p : points.points_in(cell))
              moment += points.data(seiche::PointColumn::initial_volume)[p] /
                        locator.cells.geometry(cell).measure *
                        std::pow(locator.cells.geometry(cell).to_unit(
                                   points.position(p))[d] -
                                   0.5 * height,
                                 2);
            error = std::max(error, std::abs(moment - exact) * 12.);
          }
        if (share < 1.)
          own_share = fill.extent_moment(cell);
      }
    return error;
  }

  /// An acceleration with a constant gradient, plus a constant.
  template <int dim, int degree>
  void
  set_acceleration(seiche::CellData<dim, degree> &cell, const double gradient)
  {
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < cell.n_nodes; ++a)
        {
          cell.acceleration[i][a] = 3. + i;
          for (unsigned int d = 0; d < dim; ++d)
            cell.acceleration[i][a] +=
              gradient * (1. + i + 2. * d) *
              seiche::Basis<dim, degree>::line_index(a, d) / degree;
        }
  }

  template <int dim, int degree>
  void
  check_terms()
  {
    const auto form =
      seiche::make_weak_form<dim>(seiche::PointInertiaTerm(/*factor=*/1.));
    seiche::CellData<dim, degree> cell;
    cell.extent_inertia       = 0.7;
    cell.coefficients.inertia = 11.;
    double uniform = 0., work = 0., expected = 0.;
    set_acceleration(cell, 0.);
    form->residual(cell);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < cell.n_nodes; ++a)
        uniform = std::max(uniform, std::abs(cell.residual_u[i][a]));

    set_acceleration(cell, 0.5);
    form->residual(cell);
    double sum = 0.;
    for (unsigned int i = 0; i < dim; ++i)
      {
        for (unsigned int a = 0; a < cell.n_nodes; ++a)
          {
            work += cell.residual_u[i][a] * cell.acceleration[i][a];
            sum += cell.residual_u[i][a];
          }
        for (unsigned int d = 0; d < dim; ++d)
          expected += 0.7 * std::pow(0.5 * (1. + i + 2. * d), 2);
      }

    // linear: the tangent times u, with a = C_a u, is the residual
    form->tangent(cell);
    double difference = 0.;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int a = 0; a < cell.n_nodes; ++a)
        {
          double product = 0.;
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int b = 0; b < cell.n_nodes; ++b)
              product += cell.uu[i][k][a][b] * cell.acceleration[k][b] / 11.;
          difference =
            std::max(difference, std::abs(product - cell.residual_u[i][a]));
        }
    print(dim,
          "D, degree ",
          degree,
          ": uniform acceleration ",
          uniform < 1e-13,
          ", momentum kept ",
          std::abs(sum) < 1e-13,
          ", work ",
          work / expected,
          ", tangent ",
          difference < 1e-13);
  }

  template <int dim>
  void
  test()
  {
    for (const unsigned int n : {2, 4})
      {
        double       own   = 0.;
        const double error = moment_error<dim>(n, own);
        print(dim,
              "D, ",
              n,
              " points a direction: exact moments ",
              error < 1e-12,
              ", own share in the half cell ",
              own);
      }
    check_terms<dim, 1>();
    check_terms<dim, 2>();
  }
} // namespace

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
