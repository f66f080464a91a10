// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_wall_term_h
#define seiche_formulation_wall_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /**
   * @brief No flow through walls that cut cells, weakly (Nitsche 1971;
   * doc/theory.md (8.10)):
   *
   *     R_u += int p n_t.w + gamma rho C_a h (m_t.(u - g)) m_t.w dA,
   *     R_p -= int q n_t.(u - g) dA,
   *
   * g the way of the wall's places and n_t = cof(F_t) n the normal of the wall
   * as the fluid at it is deformed: the pressure is that of PressureTerm, so
   * that a constant one does no work in a closed tank. Pressures of (4.2) and
   * these are adjoint. m is the normal of the solid itself: of a curved wall's
   * chords n has kinks, where no flow but none would pass neither.
   *
   * Where the fluid may leave and the wall would have to pull (8.10a), there is
   * no force, and R_p += int q p/(gamma rho C_a h) dA: the pressure is zero.
   */
  struct WallTerm : Term
  {
    /// Of the projection: what is pressed to the wall by the old pressure
    /// stays there.
    bool old_pressure_presses;

    explicit WallTerm(const bool old_pressure_presses = false)
      : old_pressure_presses(old_pressure_presses)
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
