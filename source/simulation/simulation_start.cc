// SPDX-License-Identifier: LGPL-2.1-or-later
// The start of a run, from the scene or from a checkpoint.
#include <seiche/simulation/simulation.h>
#include <seiche/transfer/interpolate.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  Simulation<dim>::begin()
  {
    scene.postprocessors.make(directory,
                              problem.grid,
                              communicator,
                              problem.tank_motion.any());
    scene.postprocessors.request_columns(statistics);
    const FormulationParameters &form = scene.formulation;
    if (form.is_mixed() && !form.stabilization.has_inertia() &&
        !form.lumps_inertia())
      report.warn(
        "Formulation/Subscale residual = without inertia is wrong by "
        "tau1 rho a where the fluid accelerates: outside the founding "
        "paper's recipe (prm/paper) choose whole",
        "start");
    if (start != nullptr)
      {
        save_or_load(start->state());
        scene.input.require(
          time_stepper.time() <= (1. + 1e-9) * scene.time.end_time,
          "Time/End time",
          fmt::format("the checkpoint is at {:.6g} s already; "
                      "set a later time",
                      time_stepper.time()));
        start.reset();
        return;
      }
    (void)find_material(); // bodies hold points
    prepare_start();
    state.velocity_np1 = state.velocity_n; // what the first frame shows
    state.velocity_np1.update_ghost_values();
    state.solution.update_ghost_values();
    postprocess();
  }

  template <int dim>
  void
  Simulation<dim>::prepare_start()
  {
    if (!problem.time_scheme->needs_acceleration())
      return;
    state.dt = scene.time.step;
    step_solver.find_consistent_start(state);
    interpolate_to_points(problem.occupancy,
                          state.acceleration_n,
                          PointColumn::acceleration,
                          problem.points);
    state.solution = 0.;
    state.reaction = 0.;
  }

  template void
  Simulation<2>::begin();
  template void
  Simulation<3>::begin();
  template void
  Simulation<2>::prepare_start();
  template void
  Simulation<3>::prepare_start();
} // namespace seiche
