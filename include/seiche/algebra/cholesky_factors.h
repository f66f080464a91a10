// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_cholesky_factors_h
#define seiche_algebra_cholesky_factors_h

#include <cholmod.h>

#include <vector>

namespace seiche
{
  /// Lower triangle of a symmetric matrix by columns, rows ascending.
  struct LowerTriangle
  {
    std::vector<int>    begin = {0}; ///< [column + 1]
    std::vector<int>    row;
    std::vector<double> value;
  };

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

    /// Factorise; false, and empty, if the matrix is not positive definite. The
    /// order of elimination of the matrix before serves if that had the same
    /// number of rows and @p numbering, and as long as the factors do not grow
    /// by it: a new one is a good part of the work.
    bool
    initialize(LowerTriangle &matrix, const unsigned int numbering);

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
    cholmod_common   common;
    std::vector<int> order; ///< of elimination
    unsigned int     order_numbering = 0;
    double           order_fill      = 0.; ///< entries of the factors
    cholmod_factor  *factor          = nullptr;
    cholmod_dense   *x = nullptr, *y = nullptr, *e = nullptr; ///< workspace
  };
} // namespace seiche

#endif
