// SPDX-License-Identifier: LGPL-2.1-or-later
// Nodes on convex edges of a slip block that stands in the fluid, on cells of
// different extents (doc/theory.md (8.0c)): how many slip; that no field that
// the unknowns admit crosses a face of the block, or loses its normal component
// between two cells; that uniform motion of the points arrives at the nodes
// with all its momentum, and that they leave it there if the nodes stop, also
// with elements of degree 2; that no transfer loses momentum; that friction
// brakes edges; that water at rest stays at rest and its weight arrives at the
// walls; that the tangent is the derivative of the residual, also where cells
// of two sizes meet at an edge, and where nodes are held in oblique directions
// (8.0d).
#include <seiche/grid/convex_edges.h>
#include <seiche/space/point_batch.h>

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
  at(const double cells, const double height)
  {
    std::string text;
    for (unsigned int d = 0; d < dim; ++d)
      text += (d ? ", " : "") +
              std::to_string((d == dim - 1 ? height : cells) * edges<dim>()[d]);
    return text;
  }

  template <int dim>
  std::string
  at(const double cells)
  {
    return at<dim>(cells, cells);
  }

  /// A block of 2 cells in the middle of a full tank of 6, open at the top;
  /// @p refined: cells of half the size from the middle to the right; @p level of
  /// the water [cells].
  template <int dim>
  std::string
  scene(const bool refined, const std::string &more, const double level)
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
      "\n set Upper corner = " + at<dim>(6.) + "\nend\n" + more +
      "subsection Obstacle block\n set Condition = slip\n set Friction = 0.01"
      "\n set Lower corner = " +
      at<dim>(2.) + "\n set Upper corner = " + at<dim>(4.) +
      "\nend\nsubsection Body force\n set Acceleration = " +
      (dim == 2 ? "0; -10" : "0; 0; -10") +
      "\nend\nsubsection Fluid body a\n set Lower corner = " + at<dim>(0.) +
      "\n set Upper corner = " + at<dim>(6., level) + "\nend\n";
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

    explicit Test(const bool         refined,
                  const std::string &more  = "",
                  const double       level = 6.)
      : ProblemFromText<dim>(scene<dim>(refined, more, level))
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
      Tensor<1, dim> change = -momentum();
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

    /// What the points of a flow that turns lose is what nodes and faces take.
    bool
    keeps_momentum()
    {
      double *v[dim];
      for (unsigned int d = 0; d < dim; ++d)
        v[d] = this->points.data(PointColumn::velocity, d);
      for (std::size_t p = 0; p < this->points.size(); ++p)
        for (unsigned int d = 0; d < dim; ++d)
          v[d][p] = 1. + std::sin(3. * this->points.position(p)[d] + d);
      Tensor<1, dim> change = -this->momentum();
      this->points_to_grid(state);
      state.dt             = 0.01;
      state.velocity_start = state.velocity_n;
      state.velocity_start *= 0.9;
      this->occupancy.constraints.for_each_fixed(
        [&](const auto &held) { held.set(state.velocity_start, 0.); });
      state.velocity_start.update_ghost_values();
      state.velocity_np1 = state.velocity_start;
      if (state.acceleration_n.size() > 0)
        state.acceleration_np1 = state.acceleration_n;
      change -= momentum(state.velocity_np1, Vector()) -
                momentum(state.velocity_n, state.unseen_velocity);
      this->transfer.grid_to_points(state,
                                    this->points,
                                    std::numeric_limits<double>::infinity());
      change += this->momentum();
      change = dealii::Utilities::MPI::sum(change, communicator);
      return change.norm() < 1e-9 * density;
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

  private:
    Tensor<1, dim>
    momentum() const
    {
      Tensor<1, dim> result;
      for (std::size_t p = 0; p < this->points.size(); ++p)
        for (unsigned int d = 0; d < dim; ++d)
          result[d] += this->points.data(PointColumn::mass)[p] *
                       this->points.data(PointColumn::velocity, d)[p];
      return result;
    }

    /// Of a field at the points, with what it leaves out in single cells.
    Tensor<1, dim>
    momentum(const Vector &field, const Vector &unseen) const
    {
      const auto    &occupancy = this->occupancy;
      const auto    &points    = this->points;
      Tensor<1, dim> result;
      occupancy.for_each_degree([&](const auto degree) {
        PointBatch<dim, degree, double> at;
        double                          v[dim][Basis<dim, degree>::n_nodes];
        for (const unsigned int cell : occupancy.cells.occupied())
          {
            if (occupancy.degree(cell) != degree)
              continue;
            const auto nodes = occupancy.template unknowns<degree>(cell);
            if (unseen.size() > 0)
              nodes.read(field.begin(), unseen.begin(), v);
            else
              nodes.read(field.begin(), v);
            const auto &geometry = occupancy.locator.cells.geometry(cell);
            for (const std::size_t p : points.points_in(cell))
              {
                at.reinit_values(geometry.to_unit(points.position(p)));
                for (unsigned int d = 0; d < dim; ++d)
                  result[d] +=
                    points.data(PointColumn::mass)[p] * at.value(v[d]);
              }
          }
      });
      return result;
    }

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

  /// @p mesh: 1 has cells of two sizes, 2 elements of degree 2 and a surface,
  /// so that cells at it are linear.
  template <int dim>
  void
  print_momentum(const std::string &method,
                 const char        *mass,
                 const unsigned int mesh)
  {
    const char *const meshes[] = {"", ", cells of two sizes", ", degree 2"};
    const std::string text =
      std::string(
        mesh == 2 ?
          "subsection Formulation\n set Element degree = 2\nend\n"
          "subsection Points\n set Per cell and direction = 4\nend\n" :
          "") +
      "subsection Transfer\n set Method = " + method + "\n set Mass = " + mass +
      "\nend\n";
    // of Newmark's rule, with which all edges stay fixed
    if (method == "FLIP acceleration")
      return;
    // the series need the lumped mass, which keeps the momentum of degree 1
    const bool is_lumped = mass == std::string("lumped");
    if (is_lumped ? mesh == 2 : method == "XPIC" || method == "FMPM")
      return;
    Test<dim> transfer(mesh == 1, text, mesh == 2 ? 4.5 : 6.);
    print(dim,
          "D: ",
          method,
          ", ",
          mass,
          meshes[mesh],
          ": momentum kept ",
          verdict(transfer.keeps_momentum()));
  }

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
    for (const std::string &method : transfer_names())
      for (const int mesh : {0, 1, 2})
        for (const char *mass : {"lumped", "consistent"})
          print_momentum<dim>(method, mass, mesh);
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
