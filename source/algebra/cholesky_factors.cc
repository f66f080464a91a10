// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/cholesky_factors.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    /// Entries of the factors, over those when the order was found, that call
    /// for a new one.
    constexpr double most_fill = 1.2;
  } // namespace

  CholeskyFactors::CholeskyFactors()
  {
    cholmod_start(&common);
    common.print      = 0;
    common.nmethods   = 1; // METIS takes longer than it saves
    common.supernodal = CHOLMOD_SIMPLICIAL;
    common.final_ll   = 1; // LDL' would take an indefinite matrix
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
  CholeskyFactors::initialize(LowerTriangle     &matrix,
                              const unsigned int numbering)
  {
    clear();
    cholmod_sparse view = {};
    view.nrow = view.ncol = matrix.begin.size() - 1;
    view.nzmax            = matrix.row.size();
    view.p                = matrix.begin.data();
    view.i                = matrix.row.data();
    view.x                = matrix.value.data();
    view.stype            = -1; // the lower triangle
    view.itype            = CHOLMOD_INT;
    view.xtype            = CHOLMOD_REAL;
    view.dtype            = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;

    const auto analyze = [&](const bool with_known_order) {
      common.method[0].ordering =
        with_known_order ? CHOLMOD_GIVEN : CHOLMOD_AMD;
      factor = cholmod_analyze_p(
        &view, with_known_order ? order.data() : nullptr, nullptr, 0, &common);
    };
    const bool is_known =
      order.size() == view.nrow && order_numbering == numbering;
    analyze(is_known);
    const bool is_outdated = is_known && common.lnz > most_fill * order_fill;
    if (is_outdated)
      {
        clear();
        analyze(/*with_known_order=*/false);
      }
    if (!is_known || is_outdated)
      order_fill = common.lnz;
    if (factor == nullptr || !cholmod_factorize(&view, factor, &common) ||
        common.status != CHOLMOD_OK)
      {
        clear();
        return false;
      }
    const int *permutation = static_cast<const int *>(factor->Perm);
    order.assign(permutation, permutation + view.nrow);
    order_numbering = numbering;
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
