// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/simulation.h>

#include <fmt/format.h>

// The part of Simulation that saves its state and starts from a saved one.
namespace seiche
{
  using namespace dealii;

  template <int dim>
  SeedingResult
  Simulation<dim>::fill_points(const Checkpoint *start)
  {
    if (start == nullptr)
      return seed_bodies(
        scene.seeding, bodies, scene.input, scene.materials, points);
    if (wall_motion.any())
      {
        double time = 0.;
        start->state().section("time", [&]() { start->state()("time", time); });
        locator.move(
          [this, time](const unsigned int direction, const double place) {
            return wall_motion.line(direction, place, time);
          });
      }
    start->insert_own_points(points);
    points.locate();
    if (points.n_global() != start->n_points())
      throw FileError(fmt::format("{}: {} of its {} points lie in no cell of "
                                  "the grid.",
                                  start->filename,
                                  start->n_points() - points.n_global(),
                                  start->n_points()));
    return SeedingResult(); // save_or_load() fills it
  }



  template <int dim>
  void
  Simulation<dim>::save_or_load(StateArchive &archive)
  {
    archive("initial points", seeding.n_points);
    archive("half spacing", seeding.half_spacing);
    archive("Newton iterations", newton_total);
    archive("Krylov iterations", krylov_total);
    archive("occupied cells", occupied_max);
    archive("unknowns", unknowns_max);
    archive("points are controlled", points_are_controlled);
    archive.section("time", [&]() { time_stepper.save_or_load(archive); });
    archive.section("accepted failures",
                    [&]() { accepted_failures.save_or_load(archive); });
    archive.section("points", [&]() { points.save_or_load(archive); });
    archive.section("point control",
                    [&]() { point_control.save_or_load(archive); });
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
    move_grid();
    points.locate();
    StateArchive archive;
    save_or_load(archive);
    folder.write(time_stepper.steps(), points, archive, report);
  }



  template SeedingResult
  Simulation<2>::fill_points(const Checkpoint *);
  template SeedingResult
  Simulation<3>::fill_points(const Checkpoint *);
  template void
  Simulation<2>::save_or_load(StateArchive &);
  template void
  Simulation<3>::save_or_load(StateArchive &);
  template void
  Simulation<2>::write_checkpoint(CheckpointFolder &);
  template void
  Simulation<3>::write_checkpoint(CheckpointFolder &);
} // namespace seiche
