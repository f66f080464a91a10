// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_generalized_midpoint_h
#define seiche_grid_generalized_midpoint_h

#include <seiche/grid/for_each_local.h>
#include <seiche/grid/time_scheme.h>

namespace seiche
{
  /**
   * @brief Generalized midpoint with theta = 1/(1 + rho_inf) (doc/theory.md (3.1)):
   * a = (v_1 - v_0)/dt, u = dt (theta v_1 + (1 - theta) v_0), forces in the
   * theta configuration, constraint at the end of the step, the strain of a
   * compressible fluid there or in the theta configuration.
   */
  template <int dim>
  class GeneralizedMidpoint : public TimeScheme<dim>
  {
  public:
    using Vector = typename TimeScheme<dim>::Vector;

    GeneralizedMidpoint(const double rho_infinity,
                        const bool   second_order_pressure,
                        const bool   elastic_at_end)
      : theta(1. / (1. + rho_infinity))
      , jerk(second_order_pressure ? 1. / 12. : 0.)
      , elastic_time(elastic_at_end ? 1. : theta)
    {}

    StepCoefficients
    coefficients(const double dt) const override
    {
      StepCoefficients c;
      c.dt      = dt;
      c.theta   = theta;
      c.inertia = 1. / (theta * dt * dt);
      c.rate    = 1. / dt;
      return c;
    }

    VolumeFactors
    volume_factors() const override
    {
      return {/*start_divergence=*/0.5 - theta, jerk, elastic_time};
    }

    bool
    needs_acceleration() const override
    {
      return false;
    }

    double
    pressure_time() const override
    {
      return 0.5;
    }

    double
    error_constant() const override
    {
      return 1. / 12.; // theta = 1/2; others are of first order
    }

    void
    offsets(const GridState<dim> &state,
            const double          dt,
            Vector               &inertia_offset,
            Vector               &rate_offset) const override
    {
      for_each_local(state.velocity_start, [&](const unsigned int i) {
        inertia_offset.local_element(i) =
          -state.velocity_start.local_element(i) / (theta * dt);
        rate_offset.local_element(i) = 0.;
      });
      inertia_offset.update_ghost_values();
      rate_offset.update_ghost_values();
    }

    void
    finish(GridState<dim> &state) const override
    {
      const double dt = state.dt;
      for_each_local(state.velocity_start, [&](const unsigned int i) {
        const double v0 = state.velocity_start.local_element(i);
        const double v1 =
          (state.displacement().local_element(i) / dt - (1. - theta) * v0) /
          theta;
        state.velocity_np1.local_element(i)     = v1;
        state.acceleration_np1.local_element(i) = (v1 - v0) / dt;
      });
      state.velocity_np1.update_ghost_values();
      state.acceleration_np1.update_ghost_values();
    }

  private:
    const double theta, jerk, elastic_time;
  };
} // namespace seiche

#endif
