// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/file_beside.h>
#include <seiche/parameters/parameter_table.h>
#include <seiche/simulation/earlier_results.h>
#include <seiche/simulation/run.h>
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/scene.h>
#include <seiche/simulation/scene_picture.h>
#include <seiche/simulation/scene_plan.h>
#include <seiche/simulation/simulation.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/compatibility.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/references.h>
#include <seiche/utilities/stop_signal.h>
#include <seiche/utilities/timer_tree.h>
#include <seiche/utilities/version.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <boost/crc.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

namespace seiche
{
  namespace
  {
    void
    write_parameters(const dealii::ParameterHandler &prm,
                     const std::string              &directory)
    {
      checked_file::write(directory + "/parameters.prm",
                          [&](std::ostream &stream) {
                            prm.print_parameters(
                              stream,
                              dealii::ParameterHandler::PRM |
                                dealii::ParameterHandler::KeepDeclarationOrder);
                          });
    }

    // of every scene, beside what its options cite
    constexpr const char *always_cited =
      "sulsky1994 moreno eisenstat1996 bangerth2011 p4est2011";

    /// What a run would need and a picture of the scene; no grid, no points.
    template <int dim>
    void
    validate(const Scene<dim>                  &scene,
             const std::vector<FluidBody<dim>> &bodies,
             const ScenePlan<dim>              &plan,
             const std::string                 &output)
    {
      const std::string file = output + ".svg";
      std::string       picture;
      try
        {
          const std::string title =
            std::filesystem::path(scene.input.filename).stem().string() + ": " +
            plan.size_text();
          checked_file::write(file, [&](std::ostream &stream) {
            stream << scene_picture(scene, bodies, title);
          });
          picture = "  picture: " + file + '\n';
        }
      catch (const FileError &error)
        {
          std::cerr << "warning: no picture: " << error.what() << '\n';
        }
      for (const std::string &doubt : plan.doubts(output))
        std::cerr << "warning: " << doubt << '\n';
      for (const std::string &in_vain : scene.input.without_effect())
        std::cerr << "warning: " << in_vain << '\n';
      std::cout << scene.input.filename << " is valid: " << plan.size_text()
                << '\n'
                << plan.cost_text() << picture << std::flush;
    }

    /// Entries and files of tables that a checkpoint must have, too.
    template <int dim>
    ParameterValues
    what_must_agree(const Scene<dim>               &scene,
                    const dealii::ParameterHandler &prm)
    {
      ParameterValues values = fixed_parameters(current_values(prm));
      for (const TableParameters &table : scene.tables)
        {
          const std::string text =
            checked_file::read(file_beside(scene.input, table.file));
          boost::crc_32_type checksum;
          checksum.process_bytes(text.data(), text.size());
          values["Table " + table.name + ", checksum of its file"] =
            fmt::format("{:08x}", checksum.checksum());
        }
      return values;
    }

    /// Make the folder of the results, if need be, and lock it; what a run
    /// that was killed has moved comes back. Collective.
    void
    take_folder(const std::string    &directory,
                DirectoryLock        &lock,
                const EarlierResults &earlier,
                const MPI_Comm        communicator)
    {
      try
        {
          on_first_rank(communicator,
                        [&]() { checked_file::make_directory(directory); });
        }
      catch (const FileError &error)
        {
          throw InputError(error.what()); // the user named a wrong place
        }
      on_first_rank(communicator, [&]() {
        lock.acquire(directory);
        earlier.settle();
      });
    }

    bool
    folder_exists(const std::string &directory, const MPI_Comm communicator)
    {
      bool exists = false;
      on_first_rank(communicator, [&]() {
        exists = std::filesystem::is_directory(directory);
      });
      return dealii::Utilities::MPI::broadcast(communicator, exists);
    }

    /// Room for a new run, and what is known about the old one, for the user.
    /// Collective.
    void
    clear_folder(const EarlierResults   &earlier,
                 const CheckpointFolder &folder,
                 RunReport              &report,
                 const MPI_Comm          communicator)
    {
      on_first_rank(communicator, [&]() {
        if (earlier.move_aside())
          report.header("the results of an earlier run are now in " +
                        earlier.place());
        folder.clear();
      });
    }

    /// Simulate, each time anew after a checkpoint of every n steps, until the
    /// end or until the run is asked to stop. Collective.
    template <int dim>
    ExitCode
    simulate(const CommandLine              &command_line,
             const dealii::ParameterHandler &prm,
             Scene<dim>                     &scene,
             const MPI_Comm                  communicator)
    {
      const double last_moment = wall_clock() + 3600. * command_line.max_hours;
      const std::string &directory = command_line.output;
      const bool         restarts  = command_line.restart;
      TimerTree          timer;
      DirectoryLock      lock;
      RunReport        report({directory, scene.time.end_time, scene.test_log},
                       communicator);
      CheckpointFolder folder(directory,
                              what_must_agree(scene, prm),
                              communicator);

      const EarlierResults earlier(directory);

      std::unique_ptr<Checkpoint> start;
      if (restarts)
        {
          if (folder_exists(directory, communicator))
            take_folder(directory, lock, earlier, communicator);
          folder.require_any(earlier.hint());
          start = folder.newest_usable(report);
        }
      std::unique_ptr<Simulation<dim>> simulation;
      const auto                       set_up = [&]() {
        const TimerTree::Scope scope(timer, "set-up");
        simulation = std::make_unique<Simulation<dim>>(
          scene, directory, report, timer, start.get());
      };
      set_up();

      // all input is checked once the simulation is set up; only then may
      // files of an earlier run be moved
      if (!restarts)
        take_folder(directory, lock, earlier, communicator);
      report.header(simulation->description());
      if (!restarts)
        {
          const SceneScales scales = simulation->scene_scales();
          report.header(scales.text());
          for (const std::string &text : scales.doubts())
            report.warn(text, "");
        }
      for (const std::string &text : scene.input.without_effect())
        report.warn(text, "");
      if (restarts)
        report.header("going on from " + start->filename);
      else
        clear_folder(earlier, folder, report, communicator);
      on_first_rank(communicator, [&]() {
        write_parameters(prm, directory);
        write_references(scene.input, directory);
        report.open_files(restarts);
      });
      try
        {
          stop_signal::install();
          CheckpointSchedule schedule(scene.checkpoint,
                                      directory,
                                      last_moment,
                                      communicator);
          RunOutcome         outcome;
          while ((outcome = simulation->run(schedule, folder, earlier)) ==
                 RunOutcome::restart)
            {
              simulation.reset();
              start = folder.last();
              set_up();
            }
          if (outcome == RunOutcome::finished)
            return scene.postprocessors.rejects_run() ? ExitCode::rejected :
                                                        ExitCode::finished;
          stop_signal::ignore();
          report.stop(fmt::format("stopped; to go on: seiche {} --output {} "
                                  "--restart (and the same --set)",
                                  command_line.filename,
                                  directory));
        }
      catch (const std::exception &error)
        {
          if (const std::string hint = earlier.hint(); !hint.empty())
            report.header(hint);
          report.fail(error.what());
          throw;
        }
      return ExitCode::stopped;
    }

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

    dealii::ParameterHandler prm;
    InputFile::declare_dimension(prm);
    Scene<dim> scene(input);
    scene.add_parameters(prm);
    input.parse_into(prm);
    scene.check(input);
    {
      const auto bodies =
        make_fluid_bodies(scene.bodies, input, scene.grid.domain());
      const ScenePlan<dim> plan(scene, bodies);
      plan.require_possible(
        input, dealii::Utilities::MPI::n_mpi_processes(communicator));
      if (command_line.validate)
        {
          if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
            validate(scene, bodies, plan, command_line.output);
          return ExitCode::finished;
        }
    }
    return simulate(command_line, prm, scene, communicator);
  }



  void
  write_references(const InputFile &input, const std::string &directory)
  {
    input.cites(always_cited);
    input.cites(compatibility::dealii_paper);
    checked_file::write(directory + "/methods.bib", [&](std::ostream &stream) {
      stream << "% What a text about this run should cite, from the options of "
                "its scene.\n% Of the program itself: CITATION.cff. seiche "
             << program_version << "\n";
      for (const std::string &key : input.cited())
        stream << '\n' << reference(key);
    });
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
