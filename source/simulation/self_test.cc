// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/simulation/run.h>
#include <seiche/simulation/self_test.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/embedded_files.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/result_names.h>
#include <seiche/utilities/timer_tree.h>
#include <seiche/utilities/version.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace seiche
{
  namespace
  {
    /// A folder of its own for all ranks, removed at the end.
    class TemporaryFolder
    {
    public:
      explicit TemporaryFolder(const MPI_Comm mpi_communicator)
        : communicator(mpi_communicator)
      {
        std::string made;
        on_first_rank(communicator, [&]() {
          std::error_code error;
          made = (std::filesystem::temp_directory_path(error) / "seiche-XXXXXX")
                   .string();
          if (error || mkdtemp(made.data()) == nullptr)
            throw FileError(made + ": no folder can be made; set TMPDIR to one "
                                   "that can be written to.");
        });
        path = dealii::Utilities::MPI::broadcast(communicator, made);
      }
      ~TemporaryFolder()
      {
        std::error_code ignored;
        if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
          std::filesystem::remove_all(path, ignored);
      }

      std::string path;

    private:
      const MPI_Comm communicator;
    };

    /// What a run prints goes nowhere while this lives.
    class Silence
    {
    public:
      Silence()
        : screen(std::cout.rdbuf(nowhere.rdbuf()))
      {}
      ~Silence()
      {
        std::cout.rdbuf(screen);
      }

    private:
      std::ostringstream nowhere;
      std::streambuf    *screen;
    };

    /// Numbers of the summary with the names of the verdicts on them.
    std::string
    scores(const nlohmann::json &summary)
    {
      std::string text;
      for (const auto &[name, value] : summary.at("errors").items())
        text +=
          fmt::format("{}{} {:.3g}",
                      text.empty() ? "" : ", ",
                      name,
                      value.is_number() ? value.get<double>() : std::nan(""));
      return text;
    }

    std::string
    failures(const nlohmann::json &summary)
    {
      std::string text;
      for (const auto &failed : summary.at("verdict").at("failed"))
        text += "\n         " + failed.get<std::string>();
      return text;
    }

    /// Compute one scene; empty if it is as it should be, else what is wrong.
    /// @p line: what the user reads of it. Collective.
    bool
    passes(const EmbeddedFile             &file,
           const std::vector<std::string> &overrides,
           const std::string              &folder,
           const MPI_Comm                  communicator,
           std::string                    &line)
    {
      CommandLine command_line;
      command_line.filename = folder + "/" + file.name + ".prm";
      command_line.output   = folder + "/" + file.name;
      on_first_rank(communicator, [&]() {
        checked_file::write(command_line.filename,
                            [&](std::ostream &stream) { stream << file.text; });
      });
      try
        {
          const Silence   silence;
          const InputFile input(command_line.filename, overrides);
          input.dimension() == 2 ? run<2>(command_line, input) :
                                   run<3>(command_line, input);
        }
      catch (const NumericalError &error) // on all ranks
        {
          line = error.what();
          return false;
        }
      bool        passed = false;
      std::string text;
      on_first_rank(communicator, [&]() {
        const auto summary = nlohmann::json::parse(checked_file::read(
          command_line.output + "/" + result_names::summary));
        passed             = summary.at("verdict").at("failed").empty();
        text               = scores(summary) + failures(summary);
      });
      line = text;
      return dealii::Utilities::MPI::broadcast(communicator, passed);
    }
  } // namespace



  ExitCode
  self_test(const std::vector<std::string> &overrides)
  {
    const MPI_Comm communicator = MPI_COMM_WORLD;
    const bool     speaks =
      dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    const TemporaryFolder folder(communicator);
    const auto            files = embedded_files("self_test");

    const double begin    = wall_clock();
    unsigned int n_failed = 0;
    if (speaks)
      std::cout << version_text() << std::flush;
    for (const EmbeddedFile &file : files)
      {
        const double start = wall_clock();
        std::string  line;
        const bool   passed =
          passes(file, overrides, folder.path, communicator, line);
        n_failed += !passed;
        if (speaks)
          std::cout << fmt::format("{} {:<16} {:5.1f} s  {}\n",
                                   passed ? "passed" : "FAILED",
                                   file.name,
                                   wall_clock() - start,
                                   line)
                    << std::flush;
      }
    if (speaks)
      std::cout << (n_failed == 0 ?
                      fmt::format("self-test passed: your build is fine "
                                  "({:.0f} s)\n",
                                  wall_clock() - begin) :
                      fmt::format("self-test FAILED: {} of {} scenes; please "
                                  "report what is printed here\n",
                                  n_failed,
                                  files.size()))
                << std::flush;
    return n_failed == 0 ? ExitCode::finished : ExitCode::numerical;
  }
} // namespace seiche
