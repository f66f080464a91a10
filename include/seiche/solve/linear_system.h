// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_linear_system_h
#define seiche_solve_linear_system_h

#include <seiche/solve/assembler.h>
#include <seiche/solve/linear_solver.h>

namespace seiche
{
  /// The linear system of a state of the grid: what assembles it, its matrix
  /// and what solves it, which must outlive this.
  template <int dim>
  struct LinearSystem
  {
    Assembler<dim>    &assembler;
    BlockMatrix<dim>  &matrix;
    LinearSolver<dim> &solver;

    /// Make the matrix the tangent at @p state, and the solver ready for it.
    /// Collective.
    void
    linearize(const GridState<dim> &state) const
    {
      assembler.tangent(state, matrix);
      solver.initialize(matrix, assembler, state.mass);
    }
  };
} // namespace seiche

#endif
