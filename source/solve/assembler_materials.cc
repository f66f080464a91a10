// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/assembler.h>
#include <seiche/space/node_means.h>

#include <limits>

// The part of Assembler that knows what its materials make of a cell.
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
  bool
  Assembler<dim>::tau_follows_density() const
  {
    if (!formulation.subscales->tau_is_uniform)
      return false;
    if (materials.are_uniform())
      return true;
    double least = std::numeric_limits<double>::max(), largest = 0.;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const FluidProperties fluid = materials.mean(cell);
        const double          product =
          fluid.density *
          formulation.subscales
            ->evaluate(
              tau_arguments(occupancy.locator.cells.geometry(cell).size(),
                            occupancy.degree(cell),
                            fluid,
                            /*force=*/0.))
            .momentum;
        least   = std::min(least, product);
        largest = std::max(largest, product);
      }
    const MPI_Comm communicator =
      occupancy.nodes.partitioner()->get_mpi_communicator();
    return Utilities::MPI::max(largest, communicator) <
           alike_within * Utilities::MPI::min(least, communicator);
  }

  template <int dim>
  std::vector<double>
  Assembler<dim>::viscous_stiffness(const Vector &mass,
                                    const double  least_volume) const
  {
    std::vector<double> result;
    if (!materials.largest().is_viscous())
      return result;
    result.resize(occupancy.nodes.n_own(),
                  materials.largest().stiffness(step.rate));
    if (!materials.are_uniform())
      {
        const Vector means =
          node_means(occupancy, [this](const unsigned int cell) {
            return materials.mean(cell).stiffness(step.rate);
          });
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] = means.local_element(i);
      }
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] /= std::max(materials.volume_of_node(i, mass.local_element(i)),
                            least_volume);
    return result;
  }

#define INSTANTIATE(dim)                                                    \
  template bool                Assembler<dim>::tau_follows_density() const; \
  template std::vector<double> Assembler<dim>::viscous_stiffness(           \
    const Vector &, const double) const;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
