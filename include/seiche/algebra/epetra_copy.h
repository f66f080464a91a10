// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_epetra_copy_h
#define seiche_algebra_epetra_copy_h

#include <seiche/algebra/block_matrix.h>

#include <Epetra_CrsMatrix.h>

#include <memory>

namespace seiche
{
  /// Some of the fields of each node (BlockMatrix): [first, first + n).
  struct FieldRange
  {
    unsigned int first, n;
  };

  /// Part of the matrix for Trilinos' solvers; row and column n*node + field.
  /// Zeros other than on the diagonal are left out, so that nodes away from the
  /// fluid cost nothing. Collective.
  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix>
  epetra_copy(const BlockMatrix<dim> &matrix,
              const FieldRange        rows,
              const FieldRange        columns);

  /// Diagonal entry of an own row of a square block. (Epetra keeps own columns
  /// first and in the order of the rows, so that both have one local index; its
  /// ExtractDiagonalCopy would search global indices row by row.)
  double &
  diagonal_entry(const Epetra_CrsMatrix &matrix, const int row);
} // namespace seiche

#endif
