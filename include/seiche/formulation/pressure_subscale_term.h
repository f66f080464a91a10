// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_pressure_subscale_term_h
#define seiche_formulation_pressure_subscale_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /// -V_t p~ div_t w + V0 q p~/kappa with the subscale p~ = -tau2 (g - Pi g) of
  /// the pressure (doc/theory.md (4.2) to (4.4); Codina 2000).
  struct PressureSubscaleTerm : Term
  {
    double compliance; ///< 1/kappa [1/Pa]

    explicit PressureSubscaleTerm(const double bulk_modulus)
      : compliance(1. / bulk_modulus)
    {}

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      const Lanes fine = fine_pressure(state);
      forces.pressure += state.volume_t * fine;
      forces.volume += state.volume * fine * compliance;
    }

    /// (4.7a) to (4.7d)
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree>      &sums,
                CellData<dim, degree>         &cell) const
    {
      const double tau2   = cell.tau.continuity;
      const Lanes  volume = tau2 * compliance * state.volume;
      sums.bulk += tau2 * state.volume_t;
      sums.turn +=
        cell.coefficients.theta * state.volume_t * fine_pressure(state);
      sums.pressure += tau2 * compliance * state.volume_t;
      sums.volume -= volume;
      sums.compliance -= volume * compliance;
    }

  private:
    template <int dim, int degree>
    static Lanes
    fine_pressure(const PointState<dim, degree> &state)
    {
      const auto &cell = state.cell;
      Lanes       g    = state.g;
      if (cell.orthogonal)
        g -= state.point.value(cell.projected_constraint);
      return -cell.tau.continuity * g;
    }
  };
} // namespace seiche

#endif
