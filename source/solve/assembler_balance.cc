// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/assembler.h>

// The part of Assembler that sums up what a converged step has done.
namespace seiche
{
  using namespace dealii;

  template <int dim>
  template <int degree>
  void
  Assembler<dim>::add_balance(const unsigned int    cell,
                              const GridState<dim> &state,
                              StepBalance<dim>     &balance)
  {
    CellData<dim, degree>  &data = this->template gather<degree>(cell, state);
    PointBatch<dim, degree> point;
    const auto at_point = [&](const auto &nodal) { // as the inertia term has it
      Tensor<1, dim, Lanes> result;
      for (unsigned int a = 0; a < data.n_nodes; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          result[i] +=
            (data.lumped ? point.weight(a) : point.N[a]) * nodal[i][a];
      return result;
    };
    const auto add = [](const auto &values, Tensor<1, dim> &sums) {
      for (unsigned int i = 0; i < dim; ++i)
        sums[i] += sum(values[i]);
    };
    data.quadrature.for_each_batch(
      [&](const unsigned int q, const unsigned int, const Material &) {
        const auto unit = data.quadrature.template point<Lanes>(q);
        point.reinit_values(unit);
        point.add_weights(unit);
        const Lanes           mass = load<Lanes>(&data.quadrature.mass[q]);
        const auto            u    = point.value(data.displacement);
        Tensor<1, dim, Lanes> acceleration = at_point(data.acceleration),
                              body = data.template body_force_at<Lanes>(q);
        if (data.turns)
          {
            const Tensor<1, dim, Lanes> velocity = at_point(data.rate_velocity);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                {
                  acceleration[i] -= data.coriolis[i][j] * velocity[j];
                  body[i] -= data.coriolis[i][j] * velocity[j];
                }
          }
        add(mass * acceleration, balance.inertia);
        add(mass * body, balance.body);
        add(mass * u, balance.mass_moment);
        balance.body_work += sum(mass * (body * u));
      });
  }

  template <int dim>
  StepBalance<dim>
  Assembler<dim>::balance(const GridState<dim> &state)
  {
    StepBalance<dim> sums;
    for (const unsigned int cell : occupancy.cells.occupied())
      with_degree(occupancy.degree(cell), [&](const auto degree) {
        this->template add_balance<degree>(cell, state, sums);
      });
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        sums.walls[c] += state.reaction.local_element(dim * node + c);
    for (const auto &reaction : state.solid_reactions)
      sums.walls += reaction.force;
    const MPI_Comm communicator =
      occupancy.nodes.partitioner()->get_mpi_communicator();
    sums.inertia     = Utilities::MPI::sum(sums.inertia, communicator);
    sums.body        = Utilities::MPI::sum(sums.body, communicator);
    sums.walls       = Utilities::MPI::sum(sums.walls, communicator);
    sums.body_work   = Utilities::MPI::sum(sums.body_work, communicator);
    sums.mass_moment = Utilities::MPI::sum(sums.mass_moment, communicator);
    return sums;
  }

  template StepBalance<2>
  Assembler<2>::balance(const GridState<2> &);
  template StepBalance<3>
  Assembler<3>::balance(const GridState<3> &);
} // namespace seiche
