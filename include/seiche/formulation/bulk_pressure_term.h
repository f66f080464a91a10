// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_bulk_pressure_term_h
#define seiche_formulation_bulk_pressure_term_h

#include <seiche/formulation/term.h>
#include <seiche/materials/volume_law.h>

namespace seiche
{
  /// -V_t p div_t w with p = -kappa phi(J), a function of u (doc/theory.md
  /// (4.1)).
  struct BulkPressureTerm : Term
  {
    VolumeLaw law;
    double    elastic_time; ///< VolumeFactors::elastic_time

    BulkPressureTerm(const VolumeLaw &law, const double elastic_time)
      : law(law)
      , elastic_time(elastic_time)
    {}

    template <int dim, int degree>
    Lanes
    volume_ratio(const CellData<dim, degree> &cell, const unsigned int q) const
    {
      return load<Lanes>(&cell.quadrature.volume_ratio[q]);
    }

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      const VolumeStrain<Lanes> strain(law,
                                       elastic_time,
                                       state.J_n,
                                       state.point.det_1 * state.J_n);
      state.pressure     = -law.bulk_modulus * strain.value;
      state.strain_slope = strain.slope;
    }

    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &state) const
    {
      state.set_strain_slope();
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
