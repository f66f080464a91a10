// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes on convex edges of a slip block that stands in the fluid, on cells of
// different extents (doc/theory.md (8.0c) to (8.0e)): how many are held along
// an oblique normal; that it is a unit vector into the fluid with which the
// fluxes through the two faces cancel, and P takes it out; that water at rest
// stays at rest there and its weight arrives at the walls; that the tangent is
// the derivative of the residual, also where cells of two sizes meet at an
// edge; nothing of this in the irreducible form.
#include <seiche/grid/convex_edges.h>

#include "problem_from_text.h"

namespace
{
  using namespace seiche;
  using dealii::Tensor;

  const MPI_Comm   communicator = MPI_COMM_WORLD;
  constexpr double gravity = 10., density = 1000.;

  /// Edges of the cells [m].
  template <int dim>
  Tensor<1, dim>
  edges()
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = 0.1 * (d + 1);
    return result;
  }

  template <int dim>
  std::string
  at(const double cells)
  {
    std::string text;
    for (unsigned int d = 0; d < dim; ++d)
      text += (d ? ", " : "") + std::to_string(cells * edges<dim>()[d]);
    return text;
  }

  /// A block of 2 cells in the middle of a full tank of 6, open at the top;
  /// @p refined: cells of half the size from the middle to the right.
  template <int dim>
  std::string
  scene(const bool refined)
  {
    const std::string cells[] = {"\n set Cells x = 6",
                                 "\n set Cells y = 6",
                                 "\n set Cells z = 6"};
    std::string       text =
      "subsection Walls\n set Top = open\nend\nsubsection Grid";
    for (unsigned int d = 0; d < dim; ++d)
      text += cells[d];
    text +=
      "\n set Lower corner = " + at<dim>(0.) +
      "\n set Upper corner = " + at<dim>(6.) +
      "\nend\nsubsection Obstacle block\n set Condition = slip"
      "\n set Lower corner = " +
      at<dim>(2.) + "\n set Upper corner = " + at<dim>(4.) +
      "\nend\nsubsection Body force\n set Acceleration = " +
      (dim == 2 ? "0; -10" : "0; 0; -10") +
      "\nend\nsubsection Fluid body a\n set Lower corner = " + at<dim>(0.) +
      "\n set Upper corner = " + at<dim>(6.) + "\nend\n";
    if (refined)
      text += "subsection Refinement fluid\n set Criterion = fluid\n"
              "set Level = 0\nend\n"
              "subsection Refinement right\n set Criterion = box\n"
              "set Level = 1\n set Lower corner = " +
              at<dim>(3.) + "\n set Upper corner = " + at<dim>(6.) + "\nend\n";
    return text;
  }

  template <int dim>
  class Test : public ProblemFromText<dim>
  {
  public:
    using Vector      = typename GridState<dim>::Vector;
    using BlockVector = typename GridState<dim>::BlockVector;

    explicit Test(const bool refined)
      : ProblemFromText<dim>(scene<dim>(refined))
    {
      this->find_cells();
      this->find_unknowns();
      this->points_to_grid(state);
      state.dt = 0.01;
      this->convex_edges.update(state);
      offset.reinit(this->occupancy.nodes.vector_partitioner());
      this->assembler.begin(*this->formulation.step,
                            this->time_scheme->coefficients(state.dt),
                            state,
                            offset,
                            offset);
      residual.reinit(state.solution);
    }

    bool
    is_oblique(const unsigned int node) const
    {
      return this->occupancy.constraints.is_oblique(node);
    }

    void
    print_normals() const
    {
      unsigned int n = 0, right = 0;
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        if (is_oblique(node))
          {
            ++n;
            const Tensor<1, dim> normal =
              this->occupancy.constraints.oblique_normal(node);
            const Tensor<2, dim> P =
              this->occupancy.constraints.projector(node);
            const Tensor<1, dim> from_block =
              this->occupancy.nodes.position(node) -
              3. * dealii::Point<dim>(edges<dim>());
            bool is_right = std::abs(normal.norm() - 1.) < 1e-14 &&
                            (P * normal).norm() < 1e-14 &&
                            (P * P - P).norm() < 1e-14;
            // on cells with edges e the areas of the faces go as 1/e
            double least = std::numeric_limits<double>::max(), greatest = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              if (normal[d] != 0.)
                {
                  is_right = is_right && normal[d] * from_block[d] > 0.;
                  const double area = std::abs(normal[d]) * edges<dim>()[d];
                  least             = std::min(least, area);
                  greatest          = std::max(greatest, area);
                }
            right += is_right && greatest - least < 1e-12 * greatest;
          }
      print(dim,
            "D: nodes with an oblique normal ",
            dealii::Utilities::MPI::sum(n, communicator),
            ", right ",
            dealii::Utilities::MPI::sum(right, communicator));
    }

    /// p = rho g depth, u = 0.
    void
    print_rest()
    {
      const double top = 6. * edges<dim>()[dim - 1];
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        state.pressure().local_element(node) =
          density * gravity *
          (top - this->occupancy.nodes.position(node)[dim - 1]);
      state.solution.update_ghost_values();
      this->assembler.residual(state, residual);
      Tensor<1, dim> walls;
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          walls[d] += state.reaction.local_element(dim * node + d);
      walls         = dealii::Utilities::MPI::sum(walls, communicator);
      double volume = std::pow(6., dim) - std::pow(2., dim);
      for (unsigned int d = 0; d < dim; ++d)
        volume *= edges<dim>()[d];
      walls[dim - 1] -= density * gravity * volume;
      print(dim,
            "D: water at rest stays ",
            verdict(residual.block(0).linfty_norm() < 1e-9),
            ", walls carry its weight ",
            verdict(walls.norm() < 1e-9 * density * gravity * volume));
    }

    /// Of a smooth flow that the constraints admit.
    void
    print_tangent()
    {
      BlockVector start(state.solution), direction(state.solution),
        plus(state.solution), minus(state.solution), product(state.solution);
      // a pressure of which the tangent neglects nothing
      fill(start, 1e-3, 1e7, 0.3);
      fill(direction, 1., 1e5, 1.7);
      state.solution = start;
      state.solution.update_ghost_values();
      this->assembler.residual(state, residual);
      this->assembler.tangent(state, this->matrix);
      direction.zero_out_ghost_values();
      this->matrix.vmult(product, direction);
      const double share    = 1e-6;
      const auto   evaluate = [&](const double factor, BlockVector &result) {
        state.solution.zero_out_ghost_values();
        state.solution = start;
        state.solution.add(factor, direction);
        state.solution.update_ghost_values();
        this->assembler.residual(state, result);
      };
      evaluate(share, plus);
      evaluate(-share, minus);
      plus.add(-1., minus);
      plus *= 0.5 / share;
      for (unsigned int b = 0; b < plus.n_blocks(); ++b)
        {
          const double size = plus.block(b).linfty_norm();
          plus.block(b).add(-1., product.block(b));
          print(dim,
                "D: rows of ",
                b == 0 ? "momentum" : "volume",
                ", tangent right ",
                verdict(plus.block(b).linfty_norm() < 1e-6 * size));
        }
    }

    void
    print_without_pressure()
    {
      ConvexEdges<dim> edges(this->occupancy, /*with_pressure=*/false);
      edges.reinit();
      edges.update(state);
      print(dim,
            "D: none without a pressure ",
            verdict(!this->occupancy.constraints.exist_obliques()));
    }

  private:
    void
    fill(BlockVector &v, const double u, const double p, const double phase)
    {
      v.zero_out_ghost_values();
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        {
          const auto   x = this->occupancy.nodes.position(node);
          const double a = phase + 7. * x[0] + 5. * x[1] + 3. * x[dim - 1];
          for (unsigned int d = 0; d < dim; ++d)
            v.block(0).local_element(dim * node + d) = u * std::sin(a + d);
          v.block(1).local_element(node) = p * std::cos(a);
        }
      this->occupancy.constraints.for_each_fixed(
        [&](const auto &held) { held.set(v.block(0), 0.); });
    }

    GridState<dim> state;
    Vector         offset;
    BlockVector    residual;
  };

  template <int dim>
  void
  test()
  {
    Test<dim> edges(/*refined=*/false);
    edges.print_normals();
    edges.print_rest();
    edges.print_tangent();
    edges.print_without_pressure();
    print("with cells of two sizes:");
    Test<dim> refined(/*refined=*/true);
    refined.print_rest();
    refined.print_tangent();
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
