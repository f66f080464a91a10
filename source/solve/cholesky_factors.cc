// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/cholesky_factors.h>

#include <algorithm>

namespace seiche
{
  CholeskyFactors::CholeskyFactors()
  {
    cholmod_start(&common);
    common.print              = 0;
    common.nmethods           = 1; // METIS takes longer than it saves
    common.method[0].ordering = CHOLMOD_AMD;
    common.supernodal         = CHOLMOD_SIMPLICIAL;
  }

  CholeskyFactors::~CholeskyFactors()
  {
    clear();
    cholmod_free_dense(&x, &common);
    cholmod_free_dense(&y, &common);
    cholmod_free_dense(&e, &common);
    cholmod_finish(&common);
  }

  void
  CholeskyFactors::clear()
  {
    cholmod_free_factor(&factor, &common);
  }

  bool
  CholeskyFactors::initialize(const Epetra_CrsMatrix &matrix)
  {
    clear();
    int    *begin, *columns;
    double *values;
    if (matrix.ExtractCrsDataPointers(begin, columns, values) != 0)
      return false; // its storage is not optimised
    cholmod_sparse view = {};
    view.nrow = view.ncol = matrix.NumMyRows();
    view.nzmax            = matrix.NumMyNonzeros();
    view.p                = begin;
    view.i                = columns;
    view.x                = values;
    view.stype            = -1; // by columns: the lower triangle
    view.itype            = CHOLMOD_INT;
    view.xtype            = CHOLMOD_REAL;
    view.dtype            = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;

    factor = cholmod_analyze(&view, &common);
    if (factor == nullptr || !cholmod_factorize(&view, factor, &common) ||
        common.status != CHOLMOD_OK)
      {
        clear();
        return false;
      }
    return true;
  }

  void
  CholeskyFactors::solve(double *solution, const double *right_hand_side)
  {
    const std::size_t n    = factor->n;
    cholmod_dense     view = {};
    view.nrow = view.nzmax = view.d = n;
    view.ncol                       = 1;
    view.x                          = const_cast<double *>(right_hand_side);
    view.xtype                      = CHOLMOD_REAL;
    view.dtype                      = CHOLMOD_DOUBLE;
    cholmod_solve2(
      CHOLMOD_A, factor, &view, nullptr, &x, nullptr, &y, &e, &common);
    std::copy_n(static_cast<const double *>(x->x), n, solution);
  }
} // namespace seiche
