// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/result_folder.h>
#include <seiche/simulation/scene_plan.h>
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/stepped_run.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <stdexcept>

namespace seiche
{
  namespace
  {
    /// Whose check() has been called, and which this machine can compute.
    template <int dim>
    std::unique_ptr<Scene<dim>>
    checked_scene(const InputFile &input, dealii::ParameterHandler &prm)
    {
      auto scene = std::make_unique<Scene<dim>>(input);
      InputFile::declare_dimension(prm);
      scene->add_parameters(prm);
      input.parse_into(prm);
      scene->check(input);
      const ScenePlan<dim> plan(
        *scene, make_fluid_bodies(scene->bodies, input, scene->grid.domain()));
      plan.require_possible(
        input, dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
      return scene;
    }
  } // namespace

  template <int dim>
  struct SteppedRun<dim>::Implementation
  {
    Implementation(SceneEntries entries, const std::string &directory)
      : input(entries.set("Dimension", std::to_string(dim)))
      , scene(checked_scene<dim>(input, prm))
      , report({directory,
                scene->time.end_time,
                scene->test_log,
                /*quiet=*/true},
               MPI_COMM_WORLD)
      , folder(directory, /*no checkpoints:*/ {}, MPI_COMM_WORLD)
      , simulation(*scene, directory, report, timer, /*start=*/nullptr)
    {
      folder.take();
      report.header(simulation.description());
      folder.clear(report);
      folder.begin(input, prm, report, /*continues=*/false);
      for (const std::string &text : input.without_effect())
        report.warn(text);
      simulation.begin();
    }

    const InputFile                   input;
    dealii::ParameterHandler          prm;
    const std::unique_ptr<Scene<dim>> scene;
    TimerTree                         timer;
    RunReport                         report;
    ResultFolder                      folder;
    Simulation<dim>                   simulation;
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
