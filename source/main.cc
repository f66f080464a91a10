// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/program.h>

#include <deal.II/base/mpi.h>

int
main(int argc, char **argv)
{
  seiche::prepare_process();
  // the options are ours: PETSc, which deal.II starts, would complain of them
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  return seiche::run_program(argc, argv);
}
