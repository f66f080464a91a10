// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/displacement_error.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace seiche
{
  template <int dim>
  double
  displacement_error(const GridState<dim> &state,
                     const double          error_constant,
                     const double          interval)
  {
    double mass = 0., square = 0.;
    for (unsigned int i = 0; i < state.mass.locally_owned_size(); ++i)
      {
        const double m = state.mass.local_element(i);
        mass += m;
        for (unsigned int c = dim * i; c < dim * (i + 1); ++c)
          square += m * std::pow(state.acceleration_np1.local_element(c) -
                                   state.acceleration_n.local_element(c),
                                 2);
      }
    const MPI_Comm communicator = state.mass.get_mpi_communicator();
    mass   = dealii::Utilities::MPI::sum(mass, communicator);
    square = dealii::Utilities::MPI::sum(square, communicator);
    return error_constant * std::pow(state.dt, 3) / interval *
           std::sqrt(square / mass);
  }

  template double
  displacement_error<2>(const GridState<2> &, const double, const double);
  template double
  displacement_error<3>(const GridState<3> &, const double, const double);
} // namespace seiche
