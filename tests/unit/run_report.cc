// SPDX-License-Identifier: LGPL-2.1-or-later
// The compact log of the test mode, summary.json and run.log. The report
// writes the file "output", which is compared; the rest is appended to it.
#include <seiche/simulation/run_report.h>
#include <seiche/utilities/checked_file.h>

#include <deal.II/base/mpi.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace
{
  using Json = nlohmann::ordered_json;

  Json
  example_summary()
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Json         summary;
    summary["steps"]                                      = 20;
    summary["dim"]                                        = 2;
    summary["points"]                                     = 123456;
    summary["newton_iterations"]                          = 55;
    summary["krylov_iterations"]                          = 310;
    summary["ledger"]["mass_relative_change"]             = 1e-17;
    summary["ledger"]["linear_momentum_change"]           = {1.23456789, -0.5};
    summary["ledger"]["angular_momentum_relative_change"] = nullptr;
    summary["ledger"]["lost_points"]                      = 0;
    summary["errors"]["front_rms"]                        = 0.0123456789;
    summary["errors"]["broken"]                           = nan;
    summary["added_by_the_run"] = std::numeric_limits<double>::infinity();
    return summary;
  }

  void
  run(const std::string &directory)
  {
    using namespace seiche;
    RunReport report({directory, 1., /*test_mode=*/true}, MPI_COMM_WORLD);
    report.header("said before the files are open");
    checked_file::make_directory(directory);
    report.open_files();

    TimerTree timer;
    for (unsigned int step = 1; step <= 20; ++step)
      {
        const TimerTree::Scope scope(timer, "step");
        if (step % 7 == 0)
          report.warn("a step was repeated", "step " + std::to_string(step));
        report.progress(
          0.05 * step, 0.05, 1 + step % 3, 4 + step, 1. - 1e-3 * step);
      }
    report.finish(example_summary(), timer);
  }

  void
  append_files(const std::string &directory)
  {
    std::ofstream output("output", std::ios::app);
    std::ifstream log(directory + "/run.log");
    std::string   line;
    output << "-- run.log, first lines and warnings\n";
    for (unsigned int n = 0; std::getline(log, line); ++n)
      if (n < 3 || line.compare(0, 7, "warning") == 0)
        output << line << '\n';

    output << "-- summary.json\n";
    Json summary = Json::parse(std::ifstream(directory + "/summary.json"));
    for (const char *key : {"cpu_seconds", "wall_seconds", "peak_memory_mib"})
      summary[key] = summary[key] > 0. ? "positive" : "wrong";
    for (auto &[phase, seconds] : summary["phase_seconds"].items())
      seconds = seconds >= 0. ? "not negative" : "wrong";
    summary["program_version"] = summary["program_version"].is_string();
    output << summary.dump(1) << '\n';
    output << "timing.txt exists: "
           << std::filesystem::exists(directory + "/timing.txt") << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  run("results");
  append_files("results");
}
