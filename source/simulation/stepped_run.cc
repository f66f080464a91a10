// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/planned_scene.h>
#include <seiche/simulation/result_folder.h>
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/stepped_run.h>

#include <stdexcept>

namespace seiche
{
  template <int dim>
  struct SteppedRun<dim>::Implementation
  {
    Implementation(SceneEntries entries, const std::string &directory)
      : input(entries.set("Dimension", std::to_string(dim)))
      , planned(input, MPI_COMM_WORLD)
      , report({directory,
                planned.scene.time.end_time,
                planned.scene.test_log,
                /*quiet=*/true},
               MPI_COMM_WORLD)
      , folder(directory, /*no checkpoints:*/ {}, MPI_COMM_WORLD)
      , simulation(planned, directory, report, timer, /*start=*/nullptr)
    {
      folder.take();
      report.header(simulation.description());
      folder.clear(report);
      folder.begin(input, planned.prm, report, /*continues=*/false);
      for (const std::string &text : input.without_effect())
        report.warn(text);
      simulation.begin();
    }

    const InputFile   input;
    PlannedScene<dim> planned;
    TimerTree         timer;
    RunReport         report;
    ResultFolder      folder;
    Simulation<dim>   simulation;
  };

  template <int dim>
  SteppedRun<dim>::SteppedRun(const SceneEntries &scene,
                              const std::string  &directory)
    : implementation(std::make_unique<Implementation>(scene, directory))
  {}

  template <int dim>
  SteppedRun<dim>::~SteppedRun() = default;

  template <int dim>
  void
  SteppedRun<dim>::step()
  {
    Simulation<dim> &simulation = implementation->simulation;
    if (simulation.finished())
      throw std::logic_error("SteppedRun::step() after finished()");
    simulation.advance([]() { return false; });
    if (simulation.finished())
      simulation.finish();
  }

  template <int dim>
  bool
  SteppedRun<dim>::finished() const
  {
    return implementation->simulation.finished();
  }

  template <int dim>
  double
  SteppedRun<dim>::time() const
  {
    return implementation->simulation.time();
  }

  template <int dim>
  double
  SteppedRun<dim>::value(const std::string &column) const
  {
    const StatisticsTable &table =
      implementation->simulation.statistics_table();
    if (table.has(column))
      return table.last(column);
    std::string names;
    for (const std::string &name : table.names())
      names += (names.empty() ? "\"" : ", \"") + name + "\"";
    throw std::out_of_range("no column \"" + column + "\"; there are " + names);
  }

  template <int dim>
  const PointCloud<dim> &
  SteppedRun<dim>::points() const
  {
    return problem().points;
  }

  template <int dim>
  const Problem<dim> &
  SteppedRun<dim>::problem() const
  {
    return implementation->simulation.objects();
  }

  template class SteppedRun<2>;
  template class SteppedRun<3>;
} // namespace seiche
