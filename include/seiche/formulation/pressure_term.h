// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_pressure_term_h
#define seiche_formulation_pressure_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /// -V_t p div_t w of a pressure that is an unknown (doc/theory.md (4.2)),
  /// -grad_t p in r (4.4).
  struct PressureTerm : Term
  {
    static constexpr bool has_pressure = true;

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      state.r -= state.pressure_gradient;
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      forces.pressure += state.volume_t * state.pressure;
    }

    /// (4.7a), (4.7b)
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree>      &sums,
                CellData<dim, degree>         &cell) const
    {
      sums.turn += cell.coefficients.theta * state.volume_t * state.pressure;
      sums.pressure -= state.volume_t;
    }
  };
} // namespace seiche

#endif
