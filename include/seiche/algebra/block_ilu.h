// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_block_ilu_h
#define seiche_algebra_block_ilu_h

#include <seiche/algebra/block_matrix.h>

#include <vector>

namespace seiche
{
  /**
   * @brief ILU(0) of the velocity block by dim x dim blocks, rank by rank.
   *
   * Couplings to other ranks and rows without fluid are left out. The factors
   * are kept in single precision, which a preconditioner does not notice and
   * which halves the traffic of a solve; each row is computed in double. (Saad
   * 2003, "Iterative methods for sparse linear systems", 10.3, 10.6. A scalar
   * ILU for all components, also with fill, leaves out the coupling through
   * tau2, and spray then takes many more iterations.)
   */
  template <int dim>
  class BlockILU
  {
  public:
    using Vector = typename BlockMatrix<dim>::Vector;

    /// Factorise. @p diagonal_factor strengthens the diagonal before.
    void
    initialize(const BlockMatrix<dim> &matrix, const double diagonal_factor);

    /// x = (LU)^-1 b; both may be the same vector. Local.
    void
    vmult(Vector &x, const Vector &b) const;

    /// Largest entry of the inverse applied to diag(A): about 1, and huge if
    /// the factors are unstable. Collective.
    double
    growth(const BlockMatrix<dim> &matrix) const;

    /// Rows of a stored block: padded, so that a column fills a register.
    static constexpr unsigned int n_rows = dim == 3 ? 4 : dim;

  private:
    static constexpr unsigned int size = n_rows * dim;

    /// Block rows of one factor; [block][column][row] in blocks.
    struct Triangle
    {
      std::vector<unsigned int> begin; // [row + 1]
      std::vector<unsigned int> column;
      std::vector<float>        blocks;
    };

    // apart, so that each sweep reads one stream
    Triangle           lower;    // unit diagonal
    Triangle           upper;    // without the diagonal
    std::vector<float> inverses; // [row][column][row] of U's diagonal
  };
} // namespace seiche

#endif
