// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/sparse_factors.h>

#include <Amesos.h>

#include <cmath>

namespace seiche
{
  bool
  SparseFactors::initialize(Epetra_CrsMatrix &matrix)
  {
    solver.reset(); // it refers to the others
    x       = std::make_unique<Epetra_Vector>(matrix.RowMap());
    b       = std::make_unique<Epetra_Vector>(matrix.RowMap());
    problem = std::make_unique<Epetra_LinearProblem>(&matrix, x.get(), b.get());
    solver.reset(Amesos().Create("Amesos_Klu", *problem));
    return solver->SymbolicFactorization() == 0 &&
           solver->NumericFactorization() == 0;
  }

  bool
  SparseFactors::solve()
  {
    if (solver->Solve() != 0)
      return false;
    double norm = 0.;
    x->Norm2(&norm);
    return std::isfinite(norm);
  }
} // namespace seiche
