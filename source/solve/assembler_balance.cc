// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/point_kinematics.h>
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
    CellData<dim, degree> &data = this->template gather<degree>(cell, state);
    PointKinematics<dim, degree> point;
    for (unsigned int q = 0; q < data.quadrature.size; ++q)
      {
        point.shape(data.quadrature.point(q), data.extent);
        const double   mass = data.quadrature.mass[q];
        Tensor<1, dim> acceleration, // as the inertia term has it
          u = point.value(data.displacement);
        for (unsigned int a = 0; a < data.n_nodes; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            acceleration[i] += (data.lumped ? point.lumped(a) : point.N[a]) *
                               data.acceleration[i][a];
        Tensor<1, dim> body = data.body_force_at(q);
        if (data.turns)
          {
            Tensor<1, dim> velocity;
            for (unsigned int a = 0; a < data.n_nodes; ++a)
              for (unsigned int i = 0; i < dim; ++i)
                velocity[i] += (data.lumped ? point.lumped(a) : point.N[a]) *
                               data.rate_velocity[i][a];
            const Tensor<1, dim> coriolis = data.coriolis * velocity;
            acceleration -= coriolis;
            body -= coriolis;
          }
        balance.inertia += mass * acceleration;
        balance.body += mass * body;
        balance.body_work += mass * (body * u);
        balance.mass_moment += mass * u;
      }
  }

  template <int dim>
  StepBalance<dim>
  Assembler<dim>::balance(const GridState<dim> &state)
  {
    StepBalance<dim> sums;
    for (const unsigned int cell : occupancy.occupied_cells())
      with_degree(occupancy.degree(cell), [&](const auto degree) {
        this->template add_balance<degree>(cell, state, sums);
      });
    occupancy.for_each_fixed([&](const unsigned int i) {
      sums.walls[i % dim] += state.reaction.local_element(i);
    });
    const MPI_Comm communicator =
      occupancy.scalar_partitioner()->get_mpi_communicator();
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
