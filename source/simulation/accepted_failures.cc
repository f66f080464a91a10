// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/accepted_failures.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

namespace seiche
{
  void
  AcceptedFailures::account(const NewtonResult &newton,
                            const std::size_t   n_held,
                            const double        time,
                            const MPI_Comm      communicator,
                            RunReport          &report)
  {
    if (!newton.converged)
      {
        ++steps;
        report.warn("a step was accepted that had not converged (Time/Failing "
                    "steps)",
                    fmt::format("t = {:.6g} s: {}", time, newton.failure));
      }
    const std::uint64_t held =
      dealii::Utilities::MPI::sum(std::uint64_t(n_held), communicator);
    points += held;
    if (held > 0)
      report.warn("points were held back in an accepted step (Time/Failing "
                  "steps)",
                  fmt::format("t = {:.6g} s: {} of them", time, held));
  }

  void
  AcceptedFailures::summarize(nlohmann::ordered_json &summary) const
  {
    summary[summary_numbers[0]] = steps;
    summary[summary_numbers[1]] = points;
  }

  void
  AcceptedFailures::save_or_load(StateArchive &archive)
  {
    archive("accepted failing steps", steps);
    archive("points held back", points);
  }
} // namespace seiche
