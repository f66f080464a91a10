// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/run.h>
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/stepped_run.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/first_rank.h>

#include <deal.II/base/parameter_handler.h>

#include <stdexcept>

namespace seiche
{
  namespace
  {
    /// Whose check() has been called.
    template <int dim>
    std::unique_ptr<Scene<dim>>
    checked_scene(const InputFile &input)
    {
      auto                     scene = std::make_unique<Scene<dim>>(input);
      dealii::ParameterHandler prm;
      scene->add_parameters(prm);
      input.parse_into(prm);
      scene->check(input);
      return scene;
    }
  } // namespace

  template <int dim>
  struct SteppedRun<dim>::Implementation
  {
    Implementation(SceneEntries entries, const std::string &directory)
      : input(entries.set("Dimension", std::to_string(dim)))
      , scene(checked_scene<dim>(input))
      , report({directory,
                scene->time.end_time,
                scene->test_log,
                /*quiet=*/true},
               MPI_COMM_WORLD)
      , simulation(*scene, directory, report, timer, /*start=*/nullptr)
    {
      on_first_rank(MPI_COMM_WORLD, [&]() {
        checked_file::make_directory(directory);
        lock.acquire(directory);
        write_references(input, directory);
        report.open_files();
      });
      report.header(simulation.description());
      for (const std::string &text : input.without_effect())
        report.warn(text);
      simulation.begin();
    }

    const InputFile                   input;
    const std::unique_ptr<Scene<dim>> scene;
    TimerTree                         timer;
    RunReport                         report;
    Simulation<dim>                   simulation;
    DirectoryLock                     lock;
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
    return implementation->simulation.point_cloud();
  }

  template <int dim>
  const Simulation<dim> &
  SteppedRun<dim>::simulation() const
  {
    return implementation->simulation;
  }

  template class SteppedRun<2>;
  template class SteppedRun<3>;
} // namespace seiche
