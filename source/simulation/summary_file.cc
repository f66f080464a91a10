// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/summary_file.h>
#include <seiche/utilities/version.h>

#include <deal.II/base/mpi.h>

#include <boost/serialization/map.hpp>

#include <sys/resource.h>

#include <cmath>
#include <map>
#include <string>

namespace seiche
{
  namespace
  {
    /// What other programs rely on; the order is that of the file.
    constexpr const char *summary_keys[] = {"program_version",
                                            "dim",
                                            "ranks",
                                            "points",
                                            "cells",
                                            "occupied_cells_max",
                                            "dofs_max",
                                            "end_time",
                                            "steps",
                                            "rejected_steps",
                                            "newton_iterations",
                                            "krylov_iterations",
                                            "cpu_seconds",
                                            "wall_seconds",
                                            "peak_memory_mib",
                                            "phase_seconds",
                                            "ledger",
                                            "errors",
                                            "status"};

    /// Largest resident size of this process [MiB].
    double
    peak_memory()
    {
      rusage usage{};
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) / 1024.;
    }

    void
    replace_not_finite(nlohmann::ordered_json &value,
                       const std::string      &name,
                       nlohmann::ordered_json &found)
    {
      if (value.is_structured())
        {
          const std::string prefix = (name.empty() ? "" : name + "/");
          for (auto &[key, entry] : value.items())
            replace_not_finite(entry, prefix + key, found);
        }
      else if (value.is_number_float() && !std::isfinite(value.get<double>()))
        {
          const double number = value.get<double>();
          found[name]         = std::isnan(number) ? "nan" :
                                number > 0.        ? "inf" :
                                                     "-inf";
          value               = nullptr;
        }
    }

    nlohmann::ordered_json
    sum_over_ranks(const std::map<std::string, double> &seconds,
                   const MPI_Comm                       communicator)
    {
      nlohmann::ordered_json sum = nlohmann::ordered_json::object();
      // a rank may lack a phase, so sums by position are not enough
      for (const auto &of_rank :
           dealii::Utilities::MPI::gather(communicator, seconds))
        for (const auto &[phase, value] : of_rank)
          sum[phase] = sum.value(phase, 0.) + value;
      return sum;
    }
  } // namespace



  nlohmann::ordered_json
  complete_summary(const nlohmann::ordered_json &summary,
                   const TimerTree              &timer,
                   const MPI_Comm                communicator)
  {
    namespace MPI = dealii::Utilities::MPI;

    nlohmann::ordered_json measured;
    measured["program_version"] = program_version;
    measured["ranks"]           = MPI::n_mpi_processes(communicator);
    measured["cpu_seconds"]     = MPI::sum(timer.cpu_seconds(), communicator);
    measured["wall_seconds"]    = MPI::max(timer.wall_seconds(), communicator);
    measured["peak_memory_mib"] = MPI::sum(peak_memory(), communicator);
    measured["phase_seconds"] =
      sum_over_ranks(timer.phase_seconds(), communicator);
    measured["status"] = "finished";

    nlohmann::ordered_json result;
    for (const char *key : summary_keys)
      if (summary.contains(key))
        result[key] = summary[key];
      else
        result[key] = (measured.contains(key) ? measured[key] : nullptr);
    for (const auto &[key, value] : summary.items())
      result[key] = value;

    nlohmann::ordered_json found;
    replace_not_finite(result, "", found);
    if (!found.empty())
      result["not_finite"] = found;
    return result;
  }
} // namespace seiche
