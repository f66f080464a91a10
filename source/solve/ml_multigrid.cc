// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/ml_multigrid.h>

#include <Epetra_MpiComm.h>
#include <ml_MultiLevelPreconditioner.h>

namespace seiche
{
  MLMultigrid::MLMultigrid(const DistributedRows &rows,
                           const MPI_Comm         communicator)
  {
    const int        n_rows = rows.length.size();
    const Epetra_Map map(-1, n_rows, 0, Epetra_MpiComm(communicator));
    matrix            = std::make_unique<Epetra_CrsMatrix>(Copy,
                                                map,
                                                rows.length.data(),
                                                /*StaticProfile=*/true);
    std::size_t begin = 0;
    for (int row = 0; row < n_rows; ++row)
      {
        matrix->InsertGlobalValues(rows.first + row,
                                   rows.length[row],
                                   &rows.value[begin],
                                   &rows.column[begin]);
        begin += rows.length[row];
      }
    matrix->FillComplete();
    matrix->OptimizeStorage();

    // measured: doc/journal/multigrid.md
    Teuchos::ParameterList settings;
    ML_Epetra::SetDefaults("SA", settings);
    settings.set("ML output", 0);
    settings.set("aggregation: type", "Uncoupled");
    settings.set("aggregation: threshold", 1e-4);
    // from the rows alone: the default's conjugate gradients start from random
    // numbers that go on, so that a restarted run would not be the same
    settings.set("eigen-analysis: type", "Anorm");
    settings.set("smoother: type", "symmetric Gauss-Seidel");
    settings.set("smoother: sweeps", 1);
    settings.set("coarse: type", "Amesos-KLU");
    settings.set("coarse: max size", 100);
    hierarchy.initialize(*matrix, settings);
  }

  void
  MLMultigrid::vmult(Vector &dst, const Vector &src) const
  {
    hierarchy.vmult(dst, src);
  }
} // namespace seiche
