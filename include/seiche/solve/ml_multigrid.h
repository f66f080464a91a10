// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_ml_multigrid_h
#define seiche_solve_ml_multigrid_h

#include <seiche/solve/multigrid.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <Epetra_CrsMatrix.h>

namespace seiche
{
  /// Smoothed aggregation of Trilinos' ML (Vanek, Mandel and Brezina 1996).
  class MLMultigrid : public Multigrid
  {
  public:
    MLMultigrid(const DistributedRows &rows, const MPI_Comm communicator);

    void
    vmult(Vector &dst, const Vector &src) const override;

  private:
    std::unique_ptr<Epetra_CrsMatrix>         matrix;
    dealii::TrilinosWrappers::PreconditionAMG hierarchy;
  };
} // namespace seiche

#endif
