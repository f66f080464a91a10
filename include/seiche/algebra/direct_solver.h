// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_direct_solver_h
#define seiche_algebra_direct_solver_h

#include <seiche/algebra/block_matrix.h>
#include <seiche/grid/closed_chambers.h>

namespace seiche
{
  /**
   * Solve the system with a sparse factorisation (Amesos KLU; several ranks
   * gather on one). @p closed: where the pressure is known up to a constant, one
   * of its rows is pinned; null if nowhere. Returns false, and leaves the
   * solution as it was, if the matrix is singular. Collective.
   */
  template <int dim>
  bool
  solve_directly(const BlockMatrix<dim>                       &matrix,
                 const ClosedChambers<dim>                    *closed,
                 typename BlockMatrix<dim>::BlockVector       &solution,
                 const typename BlockMatrix<dim>::BlockVector &right_hand_side);
} // namespace seiche

#endif
