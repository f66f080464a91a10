// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/ml_multigrid.h>

#include <deal.II/base/exceptions.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_MpiComm.h>
#include <Epetra_Vector.h>
#include <ml_MultiLevelPreconditioner.h>

namespace seiche
{
  namespace
  {
    std::unique_ptr<Epetra_CrsMatrix>
    copy(const DistributedRows &rows, const MPI_Comm communicator)
    {
      const int        n_rows = rows.length.size();
      const Epetra_Map map(-1, n_rows, 0, Epetra_MpiComm(communicator));
      auto             matrix = std::make_unique<Epetra_CrsMatrix>(Copy,
                                                       map,
                                                       rows.length.data(),
                                                       /*StaticProfile=*/true);
      std::size_t      begin  = 0;
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
      return matrix;
    }
  } // namespace

  MLMultigrid::MLMultigrid(const DistributedRows &rows,
                           const MPI_Comm         communicator)
    : matrix(copy(rows, communicator))
  {
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
    hierarchy =
      std::make_unique<ML_Epetra::MultiLevelPreconditioner>(*matrix, settings);
  }

  MLMultigrid::~MLMultigrid() = default;

  void
  MLMultigrid::vmult(Vector &dst, const Vector &src) const
  {
    const Epetra_Map &map = matrix->RowMap();
    Epetra_Vector     result(View, map, dst.begin());
    // ML reads it only
    const Epetra_Vector source(View, map, const_cast<double *>(src.begin()));
    const int           error = hierarchy->ApplyInverse(source, result);
    AssertThrow(error == 0, dealii::ExcInternalError());
  }
} // namespace seiche
