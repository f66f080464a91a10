// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_body_force_term_h
#define seiche_formulation_body_force_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /// -sum m b.w (doc/theory.md (4.2)), rho_t b in r (4.4). b does not depend on
  /// u, nor does the mass.
  struct BodyForceTerm : Term
  {
    static constexpr bool has_body_force = true;

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      if (state.cell.residual_parts.force)
        state.r +=
          state.rho_t * state.cell.template body_force_at<Lanes>(state.q);
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      forces.force -=
        state.mass * state.cell.template body_force_at<Lanes>(state.q);
    }
  };
} // namespace seiche

#endif
