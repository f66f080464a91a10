// SPDX-License-Identifier: LGPL-2.1-or-later
// The projection of the start velocity is linear: what its residual changes by
// is the product with its matrix, for any displacement; also where cells of one
// size have different densities (a compressed fluid), and on several ranks.
#include "problem_from_text.h"
#include "verdict.h"

namespace
{
  using namespace seiche;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  template <int dim>
  std::string
  column()
  {
    const std::string last = dim == 3 ? ", 0.4" : "";
    return "subsection Grid\n set Lower corner = 0, 0" +
           std::string(dim == 3 ? ", 0" : "") + "\n set Upper corner = 1, 1" +
           last +
           "\n set Cell size = 0.1\nend\n"
           "subsection Fluid body column\n set Lower corner = 0, 0" +
           std::string(dim == 3 ? ", 0" : "") +
           "\n set Upper corner = 0.5, 0.65" + last +
           "\nend\nsubsection Points\n set Per cell and direction = 2\nend\n";
  }

  template <int dim>
  class Test : public ProblemFromText<dim>
  {
  public:
    using Vector      = typename GridState<dim>::Vector;
    using BlockVector = typename GridState<dim>::BlockVector;

    explicit Test(const std::string &bulk_modulus)
      : ProblemFromText<dim>(column<dim>(), "1000", bulk_modulus)
    {
      for (std::size_t p = 0; p < this->points.size(); ++p)
        this->points.data(PointColumn::volume_ratio)[p] =
          1. + 0.1 * std::sin(7. * this->points.position(p)[dim - 1]);
      this->find_cells();
      this->find_unknowns();
      this->points_to_grid(state);
      state.dt = 0.01;
      offset.reinit(this->occupancy.nodes.vector_partitioner());
      StepCoefficients step;
      step.dt      = state.dt;
      step.theta   = 0.;
      step.inertia = 1. / (state.dt * state.dt);
      this->assembler.begin(
        *this->formulation.projection, step, state, offset, offset);
    }

    void
    print_error(const std::string &name)
    {
      state.solution.zero_out_ghost_values();
      state.solution = 0.;
      BlockVector zero(state.solution), change(zero), product(zero),
        direction(zero);
      this->assembler.residual(state, zero);
      this->assembler.tangent(state, this->matrix);
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        {
          if (this->matrix.is_empty(node))
            continue; // its rows are those of identity
          const auto x = this->occupancy.nodes.position(node);
          for (unsigned int d = 0; d < dim; ++d)
            direction.block(0).local_element(dim * node + d) =
              0.02 * std::sin(3. * x[0] + 2. * x[dim - 1] + d);
          direction.block(1).local_element(node) = 500. * std::cos(4. * x[1]);
        }
      this->occupancy.constraints.for_each_fixed(
        [&](const auto &fixed) { fixed.set(direction.block(0), 0.); });
      state.solution = direction;
      state.solution.update_ghost_values();
      this->assembler.residual(state, change);
      change -= zero;
      this->matrix.vmult(product, direction);
      product -= change;
      print(name,
            ": change of the residual is the product ",
            verdict(product.block(0).linfty_norm() <
                      1e-6 * change.block(0).linfty_norm() &&
                    product.block(1).linfty_norm() <
                      1e-6 * change.block(1).linfty_norm()));
    }

  private:
    GridState<dim> state;
    Vector         offset;
  };

  template <int dim>
  void
  test()
  {
    const std::string name = std::to_string(dim) + "D";
    Test<dim>("infinite").print_error(name + " incompressible");
    Test<dim>("1e6").print_error(name + " compressed");
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
