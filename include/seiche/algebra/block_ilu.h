// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_block_ilu_h
#define seiche_algebra_block_ilu_h

#include <seiche/algebra/foreign_rows.h>

#include <vector>

namespace seiche
{
  /**
   * @brief ILU(0) of the velocity block by dim x dim blocks, rank by rank with a
   * layer of overlap (restricted additive Schwarz: Cai, Sarkis 1999).
   *
   * A rank factorises its own rows and those of other ranks that they couple
   * to, and keeps what belongs to own nodes. (Without these tau2's divergence
   * sees a wall between ranks: 1.3 times the iterations on four.) Own rows
   * without fluid are left out. The factors
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

    /// Factorise. @p foreign: of the same matrix; @p diagonal_factor
    /// strengthens the diagonal before. Collective.
    void
    initialize(const BlockMatrix<dim> &matrix,
               const ForeignRows<dim> &foreign,
               const double            diagonal_factor);

    /// x = (LU)^-1 b; both may be the same vector. Collective.
    void
    vmult(Vector &x, const Vector &b) const;

    /// Largest entry of the inverse applied to diag(A): about 1, and huge if
    /// the factors are unstable. Collective.
    double
    growth(const BlockMatrix<dim> &matrix) const;

    /// Rows of a stored block: padded, so that a column fills a register.
    static constexpr unsigned int n_rows = ForeignRows<dim>::n_rows;

  private:
    static constexpr unsigned int size = n_rows * dim;

    /// Replace b by (LU)^-1 b.
    void
    solve(double *b) const;

    /// Block rows of one factor; [block][column][row] in blocks.
    struct Triangle
    {
      std::vector<unsigned int> begin; // [row + 1]
      std::vector<unsigned int> column;
      std::vector<float>        blocks;
    };

    // apart, so that each sweep reads one stream
    // own rows, then those of other ranks
    Triangle           lower;            // unit diagonal
    Triangle           upper;            // without the diagonal
    std::vector<float> inverses;         // [row][column][row] of U's diagonal
    bool               overlaps = false; // there are several ranks
    mutable Vector     extended;         // all rows, if so
  };
} // namespace seiche

#endif
