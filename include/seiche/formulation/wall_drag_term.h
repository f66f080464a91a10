// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_wall_drag_term_h
#define seiche_formulation_wall_drag_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /**
   * @brief What walls that cut cells do to the fluid along themselves, and its
   * viscous stress s across them, weakly (Nitsche 1971; Juntunen and Stenberg
   * 2009; doc/theory.md (8.11)): with T = s n, T' = s(w) n, v the velocity
   * relative to the wall (across it the mean of the step), all split across and
   * along it, and e = h/(beta k^2), k the degree,
   *
   *     R_u += int - T_n w_n - v_n T'_n + (mu/e) v_n w_n
   *              + {- e T_t.w_t - e v_t.T'_t + mu v_t.w_t
   *                 - (L e/mu) T_t.T'_t}/(L + e) dA,
   *
   * L the slip length: zero where the fluid sticks; infinite, and so without
   * the second line, where it slips. All of it in the configuration of the
   * forces.
   */
  struct WallDragTerm : Term
  {
    double beta; ///< [-]

    explicit WallDragTerm(const double beta = 10.)
      : beta(beta)
    {}

    template <int dim, int degree>
    void
    add_cell_residual(CellData<dim, degree> &cell) const;

    template <int dim, int degree>
    void
    add_cell_tangent(CellData<dim, degree> &cell) const;
  };
} // namespace seiche

#endif
