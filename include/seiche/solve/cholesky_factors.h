// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_cholesky_factors_h
#define seiche_solve_cholesky_factors_h

#include <Epetra_CrsMatrix.h>
#include <cholmod.h>

namespace seiche
{
  /// Cholesky factors of a symmetric, positive definite sparse matrix on a
  /// single rank (CHOLMOD: Chen, Davis, Hager, Rajamanickam 2008).
  class CholeskyFactors
  {
  public:
    CholeskyFactors();
    ~CholeskyFactors();
    CholeskyFactors(const CholeskyFactors &) = delete;
    CholeskyFactors &
    operator=(const CholeskyFactors &) = delete;

    /// Factorise the lower triangle of @p matrix, whose rows and columns have
    /// the same order. False if it is not positive definite.
    bool
    initialize(const Epetra_CrsMatrix &matrix);

    bool
    is_empty() const
    {
      return factor == nullptr;
    }
    void
    clear();

    /// solution = matrix^-1 right_hand_side; as many numbers as rows.
    void
    solve(double *solution, const double *right_hand_side);

  private:
    cholmod_common  common;
    cholmod_factor *factor = nullptr;
    cholmod_dense  *x = nullptr, *y = nullptr, *e = nullptr; ///< workspace
  };
} // namespace seiche

#endif
