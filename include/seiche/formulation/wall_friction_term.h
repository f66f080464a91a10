// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_wall_friction_term_h
#define seiche_formulation_wall_friction_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /**
   * @brief Skin friction of walls that cut cells, at the nodes (doc/theory.md
   * (8.11a)):
   *
   *     R_u += sum_a int M_a c_f/2 rho |v_a| v_a.w_a dA,
   *
   * M_a the piecewise multilinear functions of the nodes (positive, their sum
   * is one), v_a the velocity of node a along the wall relative to it at the
   * end of the step. So no node is braked by what another one does: light ones
   * would be turned around, and points with them.
   */
  struct WallFrictionTerm : Term
  {
    template <int dim, int degree>
    void
    add_cell_residual(CellData<dim, degree> &cell) const;

    template <int dim, int degree>
    void
    add_cell_tangent(CellData<dim, degree> &cell) const;
  };
} // namespace seiche

#endif
