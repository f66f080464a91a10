// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_volume_constraint_term_h
#define seiche_formulation_volume_constraint_term_h

#include <seiche/formulation/volume_strain_term.h>
#include <seiche/grid/time_scheme.h>

namespace seiche
{
  /**
   * @brief V0 q g, the constraint of a step (doc/theory.md (2.2), (4.3)):
   *
   *     g = phi(J) + p/kappa - jerk dt^3 (3 tr(l grad a) - 2 tr(l^3)),
   *
   * the last, div(D^2v/Dt^2), in cells that are not cut: there impacts gain
   * energy by it (3.3).
   */
  struct VolumeConstraintTerm : VolumeStrainTerm
  {
    double jerk; ///< [-] VolumeFactors::jerk

    VolumeConstraintTerm(const VolumeLaw &law, const VolumeFactors &factors)
      : VolumeStrainTerm(law, factors.elastic_time)
      , jerk(factors.jerk)
    {}

    template <int dim, int degree>
    bool
    needs_velocity_gradient(const CellData<dim, degree> &cell) const
    {
      return jerk != 0. && !cell.is_cut;
    }

    template <int dim, int degree>
    void
    evaluate(PointState<dim, degree> &state) const
    {
      state.g += strain(state) + state.pressure * (1. / law.bulk_modulus);
      if (!needs_velocity_gradient(state.cell))
        return;
      const auto &cell   = state.cell;
      const auto &l      = state.velocity_gradient;
      auto       &grad_a = state.acceleration_gradient;
      grad_a = state.point.gradient(cell.acceleration, state.point.gradient_t);
      if (cell.turns) // the constraint is one on relative motion
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int k = 0; k < dim; ++k)
            grad_a[i] -= cell.coriolis[i][k] * l[k];
      state.g -= weight(cell) * trace(3. * l * grad_a - 2. * l * l * l);
    }

    /// dg = J dphi/dJ div_1 du - tr(M grad_t du), M = (3 grad a - 6 l^2)(c_r I
    /// - theta l) + 3 l (C_a I - theta grad a) up to cyclic order.
    template <int dim, int degree>
    void
    linearize(PointState<dim, degree> &state) const
    {
      VolumeStrainTerm::linearize(state);
      if (!needs_velocity_gradient(state.cell))
        return;
      const StepCoefficients              &c      = state.cell.coefficients;
      const dealii::Tensor<2, dim, Lanes> &l      = state.velocity_gradient;
      const dealii::Tensor<2, dim, Lanes> &grad_a = state.acceleration_gradient;
      dealii::Tensor<2, dim, Lanes>        of_l   = -c.theta * l,
                                    of_a          = -c.theta * grad_a;
      for (unsigned int i = 0; i < dim; ++i)
        {
          of_l[i][i] += c.rate;
          of_a[i][i] += c.inertia;
        }
      const dealii::Tensor<2, dim, Lanes> M =
        weight(state.cell) *
        ((3. * grad_a - 6. * l * l) * of_l + 3. * l * of_a);
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int b = 0; b < state.n_nodes; ++b)
            state.g_slope[k][b] -= M[j][k] * state.point.gradient_t[j][b];
    }

    template <int dim, int degree>
    void
    add_residual(const PointState<dim, degree> &state,
                 PointForces<dim>              &forces) const
    {
      forces.volume += state.volume * state.g;
    }

    /// (4.7c), (4.7d)
    template <int dim, int degree>
    void
    add_tangent(const PointState<dim, degree> &state,
                TangentSums<dim, degree>      &sums,
                CellData<dim, degree> &) const
    {
      sums.volume += state.volume;
      sums.compliance += state.volume * (1. / law.bulk_modulus);
    }

  private:
    /// [s^3]
    template <int dim, int degree>
    double
    weight(const CellData<dim, degree> &cell) const
    {
      const double dt = cell.coefficients.dt;
      return jerk * dt * dt * dt;
    }
  };
} // namespace seiche

#endif
