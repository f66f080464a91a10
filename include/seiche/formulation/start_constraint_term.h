// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_start_constraint_term_h
#define seiche_formulation_start_constraint_term_h

#include <seiche/formulation/volume_constraint_term.h>

namespace seiche
{
  /**
   * @brief V0 q g, the constraint of what a step starts with, whatever volume
   * ratio points have:
   *
   *     g = div u + p/kappa - factor dt^2 tr(l l),
   *
   * with factor dt from u = dt v_0 the divergence of v_0 (doc/theory.md
   * (3.3a)), with one from u = dt^2 a_0 that of a_0 (3.6); l = grad v_0 does
   * not depend on u.
   */
  struct StartConstraintTerm : VolumeConstraintTerm
  {
    double factor; ///< [-]

    StartConstraintTerm(const VolumeLaw &law, const double factor)
      : VolumeConstraintTerm(law, VolumeFactors())
      , factor(factor)
    {}

    template <int dim, int degree>
    bool
    needs_velocity_gradient(const CellData<dim, degree> &) const
    {
      return factor != 0.;
    }

    template <int dim, int degree>
    Lanes
    volume_ratio(const CellData<dim, degree> &, const unsigned int) const
    {
      return 1.;
    }

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      state.g +=
        trace(state.point.H) + state.pressure * (1. / law.bulk_modulus);
      if (factor == 0.)
        return;
      const double dt = state.cell.coefficients.dt;
      const auto  &l  = state.velocity_gradient;
      state.g -= factor * dt * dt * trace(l * l);
    }

    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &state) const
    {
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int b = 0; b < state.n_nodes; ++b)
          state.g_slope[k][b] = state.point.gradient_n[k][b];
    }
  };
} // namespace seiche

#endif
