// SPDX-License-Identifier: LGPL-2.1-or-later
// The start of a run, from the scene or from a checkpoint, and its checkpoints.
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
    locate_points();
    problem.find_cells();
    points_to_grid();
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

  template <int dim>
  void
  Simulation<dim>::save_or_load(StateArchive &archive)
  {
    archive("initial points", problem.seeding.n_points);
    archive("half spacing", problem.seeding.half_spacing);
    archive("Newton iterations", newton_total);
    archive("Krylov iterations", krylov_total);
    archive("occupied cells", occupied_max);
    archive("unknowns", unknowns_max);
    archive("points are controlled", points_are_controlled);
    archive("work of solids", work_of_solids);
    archive.section("time", [&]() { time_stepper.save_or_load(archive); });
    archive.section("accepted failures",
                    [&]() { accepted_failures.save_or_load(archive); });
    archive.section("points",
                    [&]() { problem.points.outflow.save_or_load(archive); });
    archive.section("point control",
                    [&]() { problem.point_control.save_or_load(archive); });
    archive.section("statistics", [&]() { statistics.save_or_load(archive); });
    archive.section("chamber notices",
                    [&]() { chamber_notices.save_or_load(archive); });
    archive.section("report", [&]() { report.save_or_load(archive); });
    if (problem.bodies != nullptr)
      problem.bodies->save_or_load(archive);
    scene.postprocessors.save_or_load(archive);
  }

  template <int dim>
  void
  Simulation<dim>::write_checkpoint(CheckpointFolder &folder)
  {
    const TimerTree::Scope scope(timer, "checkpoint");
    // what has left the domain leaves now, so that each point lies in a cell
    problem.move_grid(time_stepper.time());
    problem.points.locate();
    StateArchive archive;
    save_or_load(archive);
    folder.write(time_stepper.steps(), problem.points, archive, report);
  }

  template void
  Simulation<2>::begin();
  template void
  Simulation<3>::begin();
  template void
  Simulation<2>::write_checkpoint(CheckpointFolder &);
  template void
  Simulation<3>::write_checkpoint(CheckpointFolder &);
} // namespace seiche
