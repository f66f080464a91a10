// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows, quoting and missing values of a statistics file.
#include <seiche/postprocess/statistics_table.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <fstream>
#include <iostream>

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  seiche::StatisticsTable table("statistics.csv");
  table.keep("step");
  for (unsigned int step = 0; step < 3; ++step)
    {
      table.set("step", step);
      table.set("time [s]", 0.1 * step);
      table.set("point a, \"b\" x [m]",
                step == 1 ? std::nan("") : 1. / (1. + step));
      table.end_row();
    }

  std::ifstream file("statistics.csv");
  std::cout << file.rdbuf() << "columns " << table.names().size() << " rows "
            << table.column("step").size() << " last " << table.last("time [s]")
            << std::endl;

  try
    {
      table.set("late", 1.);
      std::cout << "late column accepted" << std::endl;
    }
  catch (const std::exception &)
    {
      std::cout << "late column refused" << std::endl;
    }
}
