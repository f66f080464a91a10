// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/simulation.h>

#include <fmt/format.h>

// The part of Simulation that saves its state and starts from a saved one.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Shares out the cells that hold fluid at the start of a scene.
    template <int dim>
    void
    balance_by_bodies(BackgroundGrid<dim> &grid, const Scene<dim> &scene)
    {
      std::vector<std::unique_ptr<Region<dim>>> regions;
      for (const auto &body : scene.bodies)
        regions.push_back(body.make_region(scene.input, scene.grid.domain()));
      grid.balance([&](const Point<dim> &x) {
        return std::any_of(regions.begin(),
                           regions.end(),
                           [&](const auto &region) {
                             return region->contains(x);
                           });
      });
    }

    /// Shares out the cells that hold points of a checkpoint.
    template <int dim>
    void
    balance_by_points(BackgroundGrid<dim> &grid, const Checkpoint &checkpoint)
    {
      const CellLocator<dim> locator(grid);
      std::vector<bool>      filled(locator.n_owned(), false);
      checkpoint.for_each_position<dim>([&](const Point<dim> &x) {
        const unsigned int cell = locator.find(x);
        if (cell < locator.n_owned())
          filled[cell] = true;
      });
      grid.balance(
        [&](const Point<dim> &centre) { return filled[locator.find(centre)]; });
    }
  } // namespace



  template <int dim>
  const BackgroundGrid<dim> &
  Simulation<dim>::balanced_grid(const Checkpoint *start)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return grid;
    if (start != nullptr)
      balance_by_points(grid, *start);
    else
      balance_by_bodies(grid, scene);
    return grid;
  }



  template <int dim>
  SeedingResult
  Simulation<dim>::fill_points(const Checkpoint *start)
  {
    if (start == nullptr)
      return seed_bodies(
        scene.seeding, scene.bodies, scene.input, scene.fluid.density, points);
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
    archive.section("time", [&]() { time_stepper.save_or_load(archive); });
    archive.section("points", [&]() { points.save_or_load(archive); });
    archive.section("statistics", [&]() { statistics.save_or_load(archive); });
    archive.section("report", [&]() { report.save_or_load(archive); });
    scene.postprocessors.save_or_load(archive);
  }



  template <int dim>
  void
  Simulation<dim>::write_checkpoint(CheckpointFolder &folder)
  {
    const TimerTree::Scope scope(timer, "checkpoint");
    // what has left the domain leaves now, so that each point lies in a cell
    points.locate();
    StateArchive archive;
    save_or_load(archive);
    folder.write(time_stepper.steps(), points, archive);
  }



  template const BackgroundGrid<2> &
  Simulation<2>::balanced_grid(const Checkpoint *);
  template const BackgroundGrid<3> &
  Simulation<3>::balanced_grid(const Checkpoint *);
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
