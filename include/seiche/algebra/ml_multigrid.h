// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_ml_multigrid_h
#define seiche_algebra_ml_multigrid_h

#include <seiche/algebra/multigrid.h>

// of Trilinos, whose headers only ml_multigrid.cc needs
class Epetra_CrsMatrix;

namespace ML_Epetra
{
  class MultiLevelPreconditioner;
}

namespace seiche
{
  /// Smoothed aggregation of Trilinos' ML (Vanek, Mandel and Brezina 1996).
  class MLMultigrid : public Multigrid
  {
  public:
    MLMultigrid(const DistributedRows &rows, const MPI_Comm communicator);
    ~MLMultigrid() override;

    void
    vmult(Vector &dst, const Vector &src) const override;

  private:
    const std::unique_ptr<Epetra_CrsMatrix>              matrix;
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> hierarchy;
  };
} // namespace seiche

#endif
