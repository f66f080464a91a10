// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes on convex edges of a slip block that stands in the fluid, on cells of
// different extents (doc/theory.md (8.0c)): how many slip; that no field that
// the unknowns admit crosses a face of the block, or loses its normal component
// between two cells; that uniform motion of the points arrives at the nodes
// with all its momentum, and that they leave it there if the nodes stop, also
// with elements of degree 2; that friction
// brakes edges; that water at rest stays at rest and its weight arrives at the
// walls; that the tangent is the derivative of the residual, also where cells
// of two sizes meet at an edge, and where nodes are held in oblique directions
// (8.0d).
#include <seiche/grid/convex_edges.h>

#include "block_in_tank.h"

namespace
{
  using namespace seiche;
  using dealii::Tensor;

  const MPI_Comm   communicator = MPI_COMM_WORLD;
  constexpr double gravity = 10., density = 1000.;

  template <int dim>
  class Test : public ProblemFromText<dim>
  {
  public:
    using Vector      = typename GridState<dim>::Vector;
    using BlockVector = typename GridState<dim>::BlockVector;

    explicit Test(const bool refined, const std::string &more = "")
      : ProblemFromText<dim>(block_in_tank<dim>(refined, more))
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

    void
    print_edges()
    {
      unsigned int n = 0;
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        n += this->occupancy.constraints.wall_components(node) != 0 &&
             this->occupancy.constraints.fixed_components(node) == 0;
      print(dim,
            "D: nodes that slip round an edge ",
            dealii::Utilities::MPI::sum(n, communicator));
    }

    void
    print_normal_components()
    {
      fill(state.solution, 1., 0., 0.3);
      state.solution.update_ghost_values();
      const auto  &cells   = this->locator.cells;
      double       crosses = 0., jumps = 0.;
      const double size = state.displacement().linfty_norm();
      for (const unsigned int cell : this->occupancy.cells.occupied())
        for (const BoxFace face : dealii::GeometryInfo<dim>::face_indices())
          {
            const Wall<dim> *const wall  = cells.wall_at(cell, face);
            const unsigned int     other = cells.neighbor(cell, face);
            if (wall != nullptr && !wall->is_side())
              crosses = std::max(crosses, jump(cell, face, cell, face, true));
            else if (other < cells.n_owned() &&
                     cells.level(cell) == cells.level(other))
              jumps = std::max(jumps,
                               jump(cell, face, other, face.opposite(), false));
          }
      print(dim,
            "D: no flow through faces ",
            verdict(dealii::Utilities::MPI::max(crosses, communicator) <
                    1e-14 * size),
            ", normal components continuous ",
            verdict(dealii::Utilities::MPI::max(jumps, communicator) <
                    1e-14 * size));
      state.solution.zero_out_ghost_values();
      state.solution = 0.;
    }

    void
    print_uniform_motion()
    {
      for (unsigned int d = 0; d < dim; ++d)
        std::fill_n(this->points.data(PointColumn::velocity, d),
                    this->points.size(),
                    d + 1.);
      this->points_to_grid(state);
      state.dt     = 0.01;
      double error = 0.;
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          error =
            std::max(error,
                     std::abs(state.velocity_n.local_element(dim * node + d) -
                              d - 1.));
      Tensor<1, dim> change = -momentum_of(this->points);
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int i = dim * node + d;
            change[d] +=
              state.seen_mass(node, d) * state.velocity_n.local_element(i) +
              state.unseen_mass.local_element(i) *
                state.unseen_velocity.local_element(i);
          }
      change = dealii::Utilities::MPI::sum(change, communicator);
      // all stops: velocity_np1 and the displacement are zero
      this->transfer.grid_to_points(state,
                                    this->points,
                                    std::numeric_limits<double>::infinity());
      double speed = 0.;
      for (std::size_t p = 0; p < this->points.size(); ++p)
        for (unsigned int d = 0; d < dim; ++d)
          speed =
            std::max(speed,
                     std::abs(this->points.data(PointColumn::velocity, d)[p]));
      print(dim,
            "D: uniform motion arrives ",
            verdict(dealii::Utilities::MPI::max(error, communicator) < 1e-12),
            " with its momentum ",
            verdict(change.norm() < 1e-9),
            " and stays there ",
            verdict(dealii::Utilities::MPI::max(speed, communicator) < 1e-12));
    }

    void
    print_friction()
    {
      state.velocity_start = 1.;
      state.velocity_start.update_ghost_values();
      this->wall_friction.apply(state);
      unsigned int n = 0;
      for (const auto &drag : state.drags)
        n += this->occupancy.constraints.fixed_components(drag.node) == 0;
      print(dim,
            "D: edges braked ",
            dealii::Utilities::MPI::sum(n, communicator));
    }

    /// Hold the nodes of one wall in the middle of faces along a unit vector.
    void
    make_oblique()
    {
      auto          &constraints = this->occupancy.constraints;
      Tensor<1, dim> normal;
      for (unsigned int d = 0; d < dim; ++d)
        normal[d] = d + 1.;
      normal /= normal.norm();
      bool right = true;
      for (unsigned int node = 0; node < this->occupancy.nodes.n_own(); ++node)
        if (constraints.fixed_components(node) == 1u)
          {
            constraints.set_oblique(node, 1u, normal);
            const Tensor<2, dim> P = constraints.projector(node);
            right                  = right && constraints.is_oblique(node) &&
                    (P * normal).norm() < 1e-14 && (P * P - P).norm() < 1e-14;
          }
      constraints.share_obliques();
      print(dim, "D: oblique directions, projectors right ", verdict(right));
    }

    /// p = rho g depth, u = 0.
    void
    print_rest()
    {
      const double top = 6. * cell_edges<dim>()[dim - 1];
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
        volume *= cell_edges<dim>()[d];
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

  private:
    /// Largest difference of the normal components at a face that cells share;
    /// or these themselves.
    double
    jump(const unsigned int cell,
         const BoxFace      face,
         const unsigned int other,
         const BoxFace      other_face,
         const bool         alone) const
    {
      const unsigned int  d = face.direction();
      std::vector<double> here, there;
      for (const auto &[c, f, values] :
           {std::make_tuple(cell, face, &here),
            std::make_tuple(other, other_face, &there)})
        {
          double nodal[dim][Basis<dim, 1>::n_nodes];
          this->occupancy.template unknowns<1>(c).read(
            state.displacement().begin(), nodal);
          for (unsigned int a = 0; a < (Basis<dim, 1>::n_nodes); ++a)
            if (is_on_face<dim>(1, a, f))
              values->push_back(nodal[d][a]);
        }
      double result = 0.;
      for (unsigned int i = 0; i < here.size(); ++i)
        result = std::max(result, std::abs(here[i] - (alone ? 0. : there[i])));
      return result;
    }

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
    edges.print_edges();
    edges.print_normal_components();
    edges.print_uniform_motion();
    edges.print_rest();
    edges.print_tangent();
    print("with cells of two sizes:");
    Test<dim> refined(/*refined=*/true);
    refined.print_normal_components();
    refined.print_uniform_motion();
    refined.print_rest();
    refined.print_tangent();
    edges.print_friction();
    print("with elements of degree 2:");
    Test<dim> quadratic(/*refined=*/false,
                        "subsection Formulation\n set Element degree = 2\nend\n"
                        "subsection Points\n set Per cell and direction = 4\n"
                        "end\n");
    quadratic.print_edges();
    quadratic.print_uniform_motion();
    quadratic.print_rest();
    quadratic.print_tangent();
    print("with oblique directions:");
    Test<dim> oblique(/*refined=*/false);
    oblique.make_oblique();
    oblique.print_tangent();
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
