// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/declarations.h>
#include <seiche/parameters/parameter_table.h>
#include <seiche/points/seeding.h>
#include <seiche/simulation/run.h>
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/scene.h>
#include <seiche/simulation/simulation.h>
#include <seiche/utilities/checked_file.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iostream>

namespace seiche
{
  namespace
  {
    /// Call a function that touches files on rank 0; if it fails there, all
    /// ranks throw the same FileError. Collective.
    void
    on_first_rank(const MPI_Comm               communicator,
                  const std::function<void()> &function)
    {
      std::string problem;
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
        try
          {
            function();
          }
        catch (const FileError &error)
          {
            problem = error.what();
          }
      problem = dealii::Utilities::MPI::broadcast(communicator, problem);
      if (!problem.empty())
        throw FileError(problem);
    }

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

    /// Build and fill the grid as a run would; one line for the user.
    template <int dim>
    std::string
    validate(const Scene<dim> &scene, const MPI_Comm communicator)
    {
      const BackgroundGrid<dim> grid(scene.grid, communicator);
      scene.postprocessors.check(grid);
      const CellLocator<dim> locator(grid);
      PointCloud<dim>        points(locator, {}, communicator);
      seed_bodies(
        scene.seeding, scene.bodies, scene.input, scene.fluid.density, points);

      const double steps =
        std::ceil(scene.time.end_time / scene.time.step - 1e-9);
      return fmt::format("{} is valid: {}D, {} cells, {} points, about {} "
                         "steps\n",
                         scene.input.filename,
                         dim,
                         grid.triangulation.n_global_active_cells(),
                         points.n_global(),
                         steps);
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
    if (command_line.validate)
      {
        const std::string text = validate(scene, communicator);
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          std::cout << text << std::flush;
        return ExitCode::finished;
      }

    // all input is checked once the simulation is set up; only then may files
    // of an earlier run be replaced
    const std::string &directory = command_line.output;
    RunReport          report({directory, scene.time.end_time, scene.test_log},
                     communicator);
    Simulation<dim>    simulation(scene, directory, report);
    try
      {
        on_first_rank(communicator,
                      [&]() { checked_file::make_directory(directory); });
      }
    catch (const FileError &error)
      {
        throw InputError(error.what()); // the user named a wrong place
      }
    DirectoryLock lock;
    on_first_rank(communicator, [&]() {
      lock.acquire(directory);
      write_parameters(prm, directory);
      report.open_files();
    });
    try
      {
        simulation.run();
      }
    catch (const std::exception &error)
      {
        report.fail(error.what());
        throw;
      }
    return ExitCode::finished;
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
