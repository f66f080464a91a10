// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/planned_scene.h>

#include <deal.II/base/mpi.h>

namespace seiche
{
  namespace
  {
    /// The bodies of the scene, whose entries are parsed and checked here.
    template <int dim>
    std::vector<FluidBody<dim>>
    parse(Scene<dim>               &scene,
          dealii::ParameterHandler &prm,
          const InputFile          &input)
    {
      InputFile::declare_dimension(prm);
      scene.add_parameters(prm);
      input.parse_into(prm);
      scene.check(input);
      return make_fluid_bodies(scene.bodies,
                               input,
                               scene.grid.domain(),
                               scene.shapes,
                               scene.material_names());
    }
  } // namespace



  template <int dim>
  PlannedScene<dim>::PlannedScene(const InputFile &input,
                                  const MPI_Comm   communicator)
    : scene(input)
    , bodies(parse(scene, prm, input))
    , plan(scene, bodies)
  {
    plan.require_possible(
      input, dealii::Utilities::MPI::n_mpi_processes(communicator));
  }



  template class PlannedScene<2>;
  template class PlannedScene<3>;
} // namespace seiche
