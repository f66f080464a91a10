// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_planned_scene_h
#define seiche_simulation_planned_scene_h

#include <seiche/scene/fluid_body.h>
#include <seiche/simulation/scene.h>
#include <seiche/simulation/scene_plan.h>

#include <deal.II/base/parameter_handler.h>

#include <mpi.h>

#include <vector>

namespace seiche
{
  /**
   * @brief A scene read from its entries, checked, and found possible on the
   * machines of @p communicator: what every run begins with.
   */
  template <int dim>
  class PlannedScene
  {
  public:
    /// InputError for what is wrong or does not fit into memory. @p input must
    /// outlive the scene. Local.
    PlannedScene(const InputFile &input, const MPI_Comm communicator);

    dealii::ParameterHandler          prm; ///< all entries with their values
    Scene<dim>                        scene;
    const std::vector<FluidBody<dim>> bodies;
    const ScenePlan<dim>              plan;
  };
} // namespace seiche

#endif
