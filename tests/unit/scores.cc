// SPDX-License-Identifier: LGPL-2.1-or-later
// Measures, windows, reference curves and messages of scores.
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/scores.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
  /// Column "front [m]" = 1 + t^2 at t = 0, 0.1, ..., 1; the pressure time is
  /// half a step earlier; step 4 has no value of "point [m]".
  void
  fill(seiche::StatisticsTable &table)
  {
    for (unsigned int step = 0; step <= 10; ++step)
      {
        const double t = 0.1 * step;
        table.set("time [s]", t);
        table.set("dt [s]", step == 0 ? 0. : 0.1);
        table.set("pressure_time [s]", step == 0 ? 0. : t - 0.05);
        table.set("front [m]", 1. + t * t);
        table.set("point [m]", step == 4 ? std::nan("") : 2.);
        table.end_row();
      }
  }

  /// Score of a run by entries "A = b; C = d" of the subsection.
  void
  score(const std::string &title,
        const std::string &entries,
        const double       by_hand = std::nan(""))
  {
    std::ofstream      prm_file("score.prm");
    std::istringstream list(entries);
    prm_file << "set Dimension = 2\nsubsection Score s\n";
    for (std::string entry; std::getline(list, entry, ';');)
      prm_file << "  set " << entry << '\n';
    prm_file << "end\n";
    prm_file.close();
    try
      {
        const seiche::InputFile  input("score.prm", {});
        seiche::ScoreParameters  parameters;
        dealii::ParameterHandler prm;
        parameters.name = "s";
        prm.enter_subsection("Score s");
        parameters.add_parameters(prm);
        prm.leave_subsection();
        input.parse_into(prm);
        seiche::StatisticsTable statistics(""), names("");
        fill(names);
        parameters.check(input, names.names(), /*end_time=*/10.);
        const seiche::Score score(parameters, input);
        score.request(statistics);
        fill(statistics);
        std::string warning;
        const auto  value = score.evaluate(statistics, warning);
        std::cout << title << ": ";
        if (value && std::abs(*value - by_hand) < 1e-12)
          std::cout << "as by hand" << std::endl;
        else if (value)
          std::cout << *value << ", BUT BY HAND " << by_hand << std::endl;
        else
          std::cout << "none, " << warning << std::endl;
      }
    catch (const seiche::InputError &error)
      {
        std::cout << title << " -> " << error.what() << std::endl;
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  // 1 + t^2 in other units: time in ms, value in cm
  std::ofstream curve("curve.csv");
  curve << "# a comment\nname,t [ms],x [cm]\n";
  for (unsigned int i = 0; i <= 4; ++i)
    curve << "a," << 250 * i << ',' << 100. * (1. + i * i / 16.) << '\n';
  curve << "short,,\n";
  curve.close();
  std::ofstream("broken.csv") << "t,x\n0,1\n0.1,one\n";
  std::ofstream("backward.csv") << "t,x\n0,1\n0.2,1\n0.1,1\n";
  std::ofstream("short.csv") << "t,x\n0,1\n1,1\n";
  std::ofstream("headless.csv") << "0,1\n0.1,1\n";

  const std::string front = "Column = front [m];";
  const std::string table =
    "Reference table = curve.csv; Table columns = 1, 2; "
    "Table factors = 1e-3, 1e-2;";

  score("exact reference", front + "Reference = 1 + t^2", 0.);
  score("rms about one", front + "Reference = 1", std::sqrt(2.5333 / 10.));
  score("mean",
        front + "Measure = mean; Reference = 1; From = 0.5",
        (0.25 + 0.36 + 0.49 + 0.64 + 0.81 + 1.) / 6.);
  score("mean absolute",
        front + "Measure = mean absolute; Reference = 2",
        1. - 0.385);
  score("maximum",
        front + "Measure = maximum; Reference = 2; Scale = 2",
        (2. - 1.) / 2.);
  score("last, relative",
        front + "Measure = last; Reference = 4; Relative = true",
        (2. - 4.) / 4.);
  score("window", front + "Measure = last; From = 0.2; To = 0.3", 1.09);
  score("times",
        front + "Measure = maximum; Times = 0.1, 0.25; Reference = 1",
        0.5 * (0.04 + 0.09));
  score("late time", front + "Times = 0.1, 1.5");
  score("empty window", front + "From = 3");
  score("start only", front + "To = 0.05");
  score("pressure time",
        front + "Measure = last; Time column = pressure_time; Reference = t",
        2. - 0.95);
  score("missing value", "Column = point [m]; Measure = mean", 2.);
  score("reference zero", front + "Relative = true; Reference = t");
  score("linear table", front + "Measure = maximum;" + table, 0.1 * 0.15);
  // modified Akima: its slope at 0.25 s is 3/8 instead of 1/2
  score("spline table",
        front + "Measure = maximum; Interpolation = spline;" + table,
        0.125 * 0.25 * 0.8 * 0.8 * 0.2);

  score("unknown column", "Column = fornt [m]");
  score("no column", "Measure = rms");
  score("missing table", front + "Reference table = none.csv");
  score("broken table", front + "Reference table = broken.csv");
  score("backward table", front + "Reference table = backward.csv");
  score("headless table", front + "Reference table = headless.csv");
  score("short table",
        front + "Reference table = short.csv; Interpolation = spline");
  score("no such column",
        front + "Reference table = curve.csv; Table columns = 0, 3");
  score("two references", front + "Reference = 1; Reference table = curve.csv");
}
