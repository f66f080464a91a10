// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_bulk_pressure_term_h
#define seiche_formulation_bulk_pressure_term_h

#include <seiche/formulation/volume_strain_term.h>

namespace seiche
{
  /// -V_t p div_t w with p = -kappa phi(J), a function of u (doc/theory.md
  /// (4.1)).
  struct BulkPressureTerm : VolumeStrainTerm
  {
    using VolumeStrainTerm::VolumeStrainTerm;

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      state.pressure = -law.bulk_modulus * strain(state);
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      forces.pressure += state.volume_t * state.pressure;
    }

    /// (4.7a), kappa in place of tau2
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree>      &sums,
                CellData<dim, degree>         &cell) const
    {
      sums.turn += cell.coefficients.theta * state.volume_t * state.pressure;
      sums.bulk += law.bulk_modulus * state.volume_t;
    }
  };
} // namespace seiche

#endif
