// SPDX-License-Identifier: LGPL-2.1-or-later
// Momentum of the points of a flow past the edges of a slip block
// (doc/theory.md (7.2a), (8.0c)): no transfer loses any but what nodes and
// faces take.
#include <seiche/space/point_batch.h>

#include "block_in_tank.h"

namespace
{
  using namespace seiche;
  using dealii::Tensor;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  template <int dim>
  class Test : public ProblemFromText<dim>
  {
  public:
    using Vector = typename GridState<dim>::Vector;

    Test(const bool refined, const std::string &more, const double level)
      : ProblemFromText<dim>(block_in_tank<dim>(refined, more, level))
    {
      this->find_cells();
      this->find_unknowns();
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
      Tensor<1, dim> change = -momentum_of(this->points);
      this->points_to_grid(state);
      state.dt = 0.01;
      this->convex_edges.update(state);
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
      change += momentum_of(this->points);
      change = dealii::Utilities::MPI::sum(change, communicator);
      return change.norm() < 1e-6;
    }

  private:
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

    GridState<dim> state;
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
    for (const std::string &method : transfer_names())
      for (const int mesh : {0, 1, 2})
        for (const char *mass : {"lumped", "consistent"})
          print_momentum<dim>(method, mass, mesh);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
