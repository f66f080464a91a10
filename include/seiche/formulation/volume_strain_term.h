// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_volume_strain_term_h
#define seiche_formulation_volume_strain_term_h

#include <seiche/formulation/term.h>
#include <seiche/materials/volume_law.h>

namespace seiche
{
  /// What terms of the volumetric strain phi(J) share (doc/theory.md (2.2)):
  /// the volume ratio that points have, in which a finite bulk modulus keeps
  /// the pressure, and the derivative.
  struct VolumeStrainTerm : Term
  {
    VolumeLaw law;
    double    elastic_time; ///< VolumeFactors::elastic_time

    VolumeStrainTerm(const VolumeLaw &law, const double elastic_time)
      : law(law)
      , elastic_time(elastic_time)
    {}

    template <int dim, int degree>
    Lanes
    volume_ratio(const CellData<dim, degree> &cell, const unsigned int q) const
    {
      return load<Lanes>(&cell.quadrature.volume_ratio[q]);
    }

    /// dg = J dphi/dJ div_1 du
    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &state) const
    {
      state.point.evaluate_gradient_1();
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int b = 0; b < state.n_nodes; ++b)
          state.g_slope[k][b] =
            state.strain_slope * state.point.gradient_1[k][b];
    }

  protected:
    /// phi(J) at the points; sets its derivative.
    template <int dim, int degree>
    Lanes
    strain(PointState<dim, degree> &state) const
    {
      const VolumeStrain<Lanes> strain(law,
                                       elastic_time,
                                       state.J_n,
                                       state.point.det_1() * state.J_n);
      state.strain_slope = strain.slope;
      return strain.value;
    }
  };
} // namespace seiche

#endif
