// SPDX-License-Identifier: LGPL-2.1-or-later
// Nested sections: structure, sums and the uncovered rest.
#include <seiche/utilities/timer_tree.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace
{
  double sink = 0.;

  void
  work(const double seconds)
  {
    const seiche::TimerTree clock;
    while (clock.cpu_seconds() < seconds)
      sink += std::sin(sink + 1.);
  }

  /// Names and calls, with the indentation; the rest differs from run to run.
  void
  print_structure(const std::string &report)
  {
    std::istringstream lines(report);
    std::string        line;
    std::getline(lines, line);
    while (std::getline(lines, line))
      {
        const std::string name =
          line.substr(0, line.find_last_not_of(' ', 39) + 1);
        std::istringstream rest(line.substr(40, 9));
        std::string        calls;
        rest >> calls;
        std::cout << name << " " << calls << std::endl;
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  seiche::TimerTree tree;
  for (unsigned int step = 0; step < 3; ++step)
    {
      seiche::TimerTree::Scope solve(tree, "solve");
      work(0.01);
      for (unsigned int i = 0; i < 2; ++i)
        {
          seiche::TimerTree::Scope assemble(tree, "assemble");
          work(0.01);
        }
    }
  try
    {
      seiche::TimerTree::Scope output(tree, "output");
      seiche::TimerTree::Scope grid(tree, "grid");
      throw std::runtime_error("leaves both sections");
    }
  catch (const std::runtime_error &)
    {}
  work(0.02);

  print_structure(tree.report());

  const auto phases = tree.phase_seconds();
  double     sum    = 0.;
  for (const auto &[name, seconds] : phases)
    {
      std::cout << "phase " << name << std::endl;
      sum += seconds;
    }
  const double total = tree.cpu_seconds();
  std::cout << "assemble at least 0.06 s: " << (phases.at("assemble") >= 0.059)
            << "\nother at least 0.05 s: " << (phases.at("other") >= 0.049)
            << "\nphases add up: " << (std::abs(sum / total - 1.) < 0.05)
            << "\nwall not shorter than a tenth: "
            << (tree.wall_seconds() > 0.1 * total) << std::endl;

  // an open section counts
  seiche::TimerTree::Scope open(tree, "open");
  work(0.01);
  std::cout << "open section counts: "
            << (tree.phase_seconds().at("open") >= 0.009) << std::endl;
}
