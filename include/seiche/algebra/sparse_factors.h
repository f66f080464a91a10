// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_sparse_factors_h
#define seiche_algebra_sparse_factors_h

#include <Amesos_BaseSolver.h>
#include <Epetra_CrsMatrix.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>

#include <memory>

namespace seiche
{
  /// LU factors of a sparse matrix on all ranks (KLU, Davis and Palamadai
  /// Natarajan 2010).
  class SparseFactors
  {
  public:
    /// Factorise; @p matrix must live as long as this. False if it is
    /// singular. Collective.
    bool
    initialize(Epetra_CrsMatrix &matrix);

    /// Where solve() finds the right-hand side and leaves the solution: own
    /// rows of the matrix.
    Epetra_Vector &
    right_hand_side()
    {
      return *b;
    }
    Epetra_Vector &
    solution()
    {
      return *x;
    }

    /// False if the solution is not finite. Collective.
    bool
    solve();

  private:
    std::unique_ptr<Epetra_Vector>        x, b;
    std::unique_ptr<Epetra_LinearProblem> problem;
    std::unique_ptr<Amesos_BaseSolver>    solver;
  };
} // namespace seiche

#endif
