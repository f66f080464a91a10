// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/simulation.h>

#include <fmt/format.h>

// The part of Simulation that saves its state and starts from a saved one.
namespace seiche
{
  using namespace dealii;

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
    archive.section("time", [&]() { time_stepper.save_or_load(archive); });
    archive.section("accepted failures",
                    [&]() { accepted_failures.save_or_load(archive); });
    archive.section("points", [&]() { problem.points.save_or_load(archive); });
    archive.section("point control",
                    [&]() { problem.point_control.save_or_load(archive); });
    archive.section("statistics", [&]() { statistics.save_or_load(archive); });
    archive.section("chamber notices",
                    [&]() { chamber_notices.save_or_load(archive); });
    archive.section("report", [&]() { report.save_or_load(archive); });
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
  Simulation<2>::save_or_load(StateArchive &);
  template void
  Simulation<3>::save_or_load(StateArchive &);
  template void
  Simulation<2>::write_checkpoint(CheckpointFolder &);
  template void
  Simulation<3>::write_checkpoint(CheckpointFolder &);
} // namespace seiche
