// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/viscous_stress.h>
#include <seiche/solve/assembler.h>
#include <seiche/space/node_means.h>

#include <limits>

// The part of Assembler that knows densities and viscosities of the cells.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Largest over smallest rho tau1 up to which the pressure block counts as
    /// a scaled copy of the Schur complement: as many more iterations at most.
    constexpr double alike_within = 2.;
  } // namespace

  template <int dim>
  void
  Assembler<dim>::find_viscosities(const GridState<dim> &state)
  {
    viscosities.clear();
    viscosity_everywhere = 0.;
    if (!weak_form->has_viscosity)
      return;
    if (!materials.are_several() && materials.has_constant_viscosity())
      {
        viscosity_everywhere = materials.all()[0].law->scale;
        return;
      }
    viscosities.assign(occupancy.locator.n_cells(), 0.);
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        viscosities[cell] =
          materials.has_constant_viscosity() ?
            materials.viscosity(cell, /*gamma_square=*/0.) :
            with_degree(occupancy.degree(cell), [&](const auto degree) {
              return this->template start_viscosity<degree>(cell, state);
            });
        viscosity_everywhere =
          std::max(viscosity_everywhere, viscosities[cell]);
      }
    occupancy.locator.exchange_to_ghosts(viscosities);
    viscosity_everywhere = Utilities::MPI::max(
      viscosity_everywhere,
      occupancy.scalar_partitioner()->get_mpi_communicator());
  }

  template <int dim>
  template <int degree>
  double
  Assembler<dim>::start_viscosity(const unsigned int    cell,
                                  const GridState<dim> &state) const
  {
    PointBatch<dim, degree, double> centre;
    centre.reinit(occupancy.locator.geometry(cell),
                  CellGeometry<dim>::unit_centre());
    double velocity[dim][CellData<dim, degree>::n_nodes];
    occupancy.template unknowns<degree>(cell).read(state.velocity_start.begin(),
                                                   velocity);
    return materials.viscosity(
      cell, gamma_square(shear_rate(centre.gradient(velocity))));
  }

  template <int dim>
  Tau
  Assembler<dim>::reference_tau(const double size, const double force) const
  {
    return formulation.subscales->evaluate(
      tau_arguments(size,
                    occupancy.fe.degree,
                    materials.largest_density(),
                    largest_viscosity(),
                    force));
  }

  template <int dim>
  bool
  Assembler<dim>::tau_follows_density() const
  {
    if (!formulation.subscales->tau_is_uniform)
      return false;
    if (!materials.are_several() && viscosities.empty())
      return true;
    double least = std::numeric_limits<double>::max(), largest = 0.;
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        const double density = materials.density(cell);
        const double size    = occupancy.locator.geometry(cell).size();
        const double product =
          density * formulation.subscales
                      ->evaluate(tau_arguments(size,
                                               occupancy.degree(cell),
                                               density,
                                               viscosity(cell),
                                               /*force=*/0.))
                      .momentum;
        least   = std::min(least, product);
        largest = std::max(largest, product);
      }
    const MPI_Comm communicator =
      occupancy.scalar_partitioner()->get_mpi_communicator();
    return Utilities::MPI::max(largest, communicator) <
           alike_within * Utilities::MPI::min(least, communicator);
  }

  template <int dim>
  std::vector<double>
  Assembler<dim>::viscous_stiffness(const Vector &mass,
                                    const double  least_volume) const
  {
    std::vector<double> result;
    if (!weak_form->has_viscosity || materials.are_inviscid())
      return result;
    result.resize(occupancy.n_own_nodes(), viscosity_everywhere);
    if (!viscosities.empty())
      {
        const Vector means =
          node_means(occupancy, [this](const unsigned int cell) {
            return viscosities[cell];
          });
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] = means.local_element(i);
      }
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] *=
        2. * step.rate /
        std::max(mass.local_element(i) / materials.density_of_node(i),
                 least_volume);
    return result;
  }

#define INSTANTIATE(dim)                                                    \
  template void Assembler<dim>::find_viscosities(const GridState<dim> &);   \
  template Tau  Assembler<dim>::reference_tau(const double, const double)   \
    const;                                                                  \
  template bool                Assembler<dim>::tau_follows_density() const; \
  template std::vector<double> Assembler<dim>::viscous_stiffness(           \
    const Vector &, const double) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
