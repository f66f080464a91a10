// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/displacement_error.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace seiche
{
  template <int dim>
  double
  displacement_error(const GridState<dim>       &state,
                     const NodeConstraints<dim> &constraints,
                     const double                error_constant,
                     const double                interval)
  {
    double mass = 0., square = 0.;
    for (unsigned int node = 0; node < state.mass.locally_owned_size(); ++node)
      {
        mass += state.mass.local_element(node);
        dealii::Tensor<1, dim> change;
        for (unsigned int c = 0; c < dim; ++c)
          change[c] = state.acceleration_np1.local_element(dim * node + c) -
                      state.acceleration_n.local_element(dim * node + c);
        // what walls prescribe has no error
        if (constraints.fixed_components(node) != 0)
          change = constraints.projector(node) * change;
        for (unsigned int c = 0; c < dim; ++c)
          square += state.seen_mass(node, c) * change[c] * change[c];
      }
    const MPI_Comm communicator = state.mass.get_mpi_communicator();
    mass   = dealii::Utilities::MPI::sum(mass, communicator);
    square = dealii::Utilities::MPI::sum(square, communicator);
    return error_constant * std::pow(state.dt, 3) / interval *
           std::sqrt(square / mass);
  }

  template double
  displacement_error<2>(const GridState<2> &,
                        const NodeConstraints<2> &,
                        const double,
                        const double);
  template double
  displacement_error<3>(const GridState<3> &,
                        const NodeConstraints<3> &,
                        const double,
                        const double);
} // namespace seiche
