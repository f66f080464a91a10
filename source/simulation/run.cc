// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/parameter_table.h>
#include <seiche/simulation/planned_scene.h>
#include <seiche/simulation/result_folder.h>
#include <seiche/simulation/run.h>
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/scene.h>
#include <seiche/simulation/simulation.h>
#include <seiche/simulation/validation.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/failure_text.h>
#include <seiche/utilities/process_memory.h>
#include <seiche/utilities/stop_signal.h>
#include <seiche/utilities/timer_tree.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <boost/crc.hpp>

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace seiche
{
  namespace
  {
    /// Entries and files of tables that a checkpoint must have, too.
    template <int dim>
    ParameterValues
    what_must_agree(const PlannedScene<dim> &planned)
    {
      const Scene<dim> &scene  = planned.scene;
      ParameterValues   values = fixed_parameters(current_values(planned.prm));
      for (const TableParameters &table : scene.tables)
        {
          const std::string text =
            checked_file::read(scene.input.file_beside(table.file));
          boost::crc_32_type checksum;
          checksum.process_bytes(text.data(), text.size());
          // what is in it counts, not where it is
          values["Table " + table.name + "/File"] =
            fmt::format("checksum {:08x}", checksum.checksum());
        }
      return values;
    }

    /// What is said of a run before its first step.
    template <int dim>
    void
    introduce(const PlannedScene<dim> &planned,
              const std::string       &description,
              const std::string       &origin, // of a run that goes on
              RunReport               &report)
    {
      report.header(description);
      if (origin.empty())
        {
          const SceneScales &scales = planned.plan.scales;
          report.header(scales.text());
          for (const std::string &text : scales.doubts())
            report.warn(text, "");
        }
      for (const std::string &text : planned.scene.input.without_effect())
        report.warn(text, "");
      if (!origin.empty())
        report.header("going on from " + origin);
    }

    /// A run: simulations that follow each other, each from a checkpoint of
    /// the one before.
    template <int dim>
    class Run
    {
    public:
      Run(const CommandLine &run_command_line,
          PlannedScene<dim> &planned_scene,
          const MPI_Comm     mpi_communicator)
        : command_line(run_command_line)
        , planned(planned_scene)
        , scene(planned.scene)
        , communicator(mpi_communicator)
        , last_moment(wall_clock() + 3600. * command_line.max_hours)
        , report({command_line.output, scene.time.end_time, scene.test_log},
                 communicator)
        , folder(command_line.output, what_must_agree(planned), communicator)
      {}

      /// Until the end or until the run is asked to stop. Collective.
      ExitCode
      execute()
      {
        begin();
        try
          {
            stop_signal::install();
            if (simulate() == RunOutcome::finished)
              return scene.postprocessors.rejects_run() ? ExitCode::rejected :
                                                          ExitCode::finished;
            stop_signal::ignore();
            report.stop(fmt::format("stopped; to go on: seiche {} --output {} "
                                    "--restart (and the same --set)",
                                    command_line.filename,
                                    command_line.output));
            return ExitCode::stopped;
          }
        catch (const std::exception &error)
          {
            if (const std::string hint = folder.earlier.hint(); !hint.empty())
              report.header(hint);
            report.fail(failure_text(error));
            throw;
          }
      }

    private:
      void
      begin()
      {
        const bool  restarts = command_line.restart;
        std::string origin;
        if (restarts)
          {
            if (folder.exists())
              folder.take();
            folder.checkpoints.require_any(folder.earlier.hint());
            start  = folder.checkpoints.newest_usable(report);
            origin = start->filename;
          }
        set_up();

        // all input is checked once the simulation is set up; only then may
        // files of an earlier run be moved
        if (!restarts)
          folder.take();
        introduce(planned, simulation->description(), origin, report);
        if (!restarts)
          folder.clear(report);
        folder.begin(scene.input, planned.prm, report, restarts);
      }

      void
      set_up()
      {
        const TimerTree::Scope scope(timer, "set-up");
        simulation = std::make_unique<Simulation<dim>>(
          planned, command_line.output, report, timer, std::move(start));
      }

      /// Each time anew after a checkpoint of every n steps.
      RunOutcome
      simulate()
      {
        CheckpointSchedule schedule(scene.checkpoint,
                                    command_line.output,
                                    last_moment,
                                    communicator);
        RunOutcome         outcome;
        while (
          (outcome =
             simulation->run(schedule, folder.checkpoints, folder.earlier)) ==
          RunOutcome::restart)
          {
            simulation.reset();
            return_freed_memory(); // hardly anything is in use now
            start = folder.checkpoints.last();
            set_up();
          }
        return outcome;
      }

      const CommandLine &command_line;
      PlannedScene<dim> &planned;
      Scene<dim>        &scene;
      const MPI_Comm     communicator;
      const double       last_moment; // on the wall clock [s]
      TimerTree          timer;
      RunReport          report;
      ResultFolder       folder;

      std::unique_ptr<const Checkpoint> start; // of the next simulation
      std::unique_ptr<Simulation<dim>>  simulation;
    };

    template <int dim>
    std::vector<Declaration>
    scene_declarations()
    {
      const InputFile          input = InputFile::for_documentation();
      dealii::ParameterHandler prm;
      InputFile::declare_dimension(prm);
      Scene<dim> scene(input);
      scene.add_parameters(prm);
      return declarations(prm);
    }
  } // namespace



  template <int dim>
  ExitCode
  run(const CommandLine &command_line, const InputFile &input)
  {
    const MPI_Comm communicator = MPI_COMM_WORLD;

    PlannedScene<dim> planned(input, communicator);
    if (command_line.validate)
      {
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          validate(planned, command_line.output);
        return ExitCode::finished;
      }
    return Run<dim>(command_line, planned, communicator).execute();
  }



  std::string
  parameter_text()
  {
    return parameter_table(scene_declarations<2>(), scene_declarations<3>());
  }



  template ExitCode
  run<2>(const CommandLine &, const InputFile &);
  template ExitCode
  run<3>(const CommandLine &, const InputFile &);
} // namespace seiche
