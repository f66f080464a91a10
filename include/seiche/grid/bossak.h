// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_bossak_h
#define seiche_grid_bossak_h

#include <seiche/grid/for_each_local.h>
#include <seiche/grid/time_scheme.h>

namespace seiche
{
  /**
   * @brief Newmark (beta, gamma) with Bossak's weighted inertia (doc/theory.md
   * (3.1)): a = c_a u + a^, v = c_v u + v^, inertia (1 - alpha) a + alpha
   * a_n. alpha = 0, beta = 1/4, gamma = 1/2: the scheme of the founding
   * paper.
   */
  template <int dim>
  class Bossak : public TimeScheme<dim>
  {
  public:
    using Vector = typename TimeScheme<dim>::Vector;

    explicit Bossak(const double alpha)
      : alpha(alpha)
      , beta((1. - alpha) * (1. - alpha) / 4.)
      , gamma(0.5 - alpha)
    {}

    StepCoefficients
    coefficients(const double dt) const override
    {
      StepCoefficients c;
      c.dt      = dt;
      c.theta   = 1.;
      c.inertia = (1. - alpha) / (beta * dt * dt);
      c.rate    = gamma / (beta * dt);
      return c;
    }

    VolumeFactors
    volume_factors() const override
    {
      return {};
    }

    bool
    needs_acceleration() const override
    {
      return true;
    }

    double
    pressure_time() const override
    {
      return 1.;
    }

    double
    error_constant() const override
    {
      return beta - 1. / 6.;
    }

    void
    offsets(const GridState<dim> &state,
            const double          dt,
            Vector               &inertia_offset,
            Vector               &rate_offset) const override
    {
      for_each_local(state.velocity_start, [&](const unsigned int i) {
        const double v = state.velocity_start.local_element(i);
        const double a = state.acceleration_n.local_element(i);
        inertia_offset.local_element(i) =
          (1. - alpha) * acceleration_offset(v, a, dt) + alpha * a;
        rate_offset.local_element(i) = velocity_offset(v, a, dt);
      });
      inertia_offset.update_ghost_values();
      rate_offset.update_ghost_values();
    }

    void
    finish(GridState<dim> &state) const override
    {
      const double dt = state.dt;
      for_each_local(state.velocity_start, [&](const unsigned int i) {
        const double u = state.displacement().local_element(i);
        const double v = state.velocity_start.local_element(i);
        const double a = state.acceleration_n.local_element(i);
        state.velocity_np1.local_element(i) =
          gamma / (beta * dt) * u + velocity_offset(v, a, dt);
        state.acceleration_np1.local_element(i) =
          u / (beta * dt * dt) + acceleration_offset(v, a, dt);
      });
      state.velocity_np1.update_ghost_values();
      state.acceleration_np1.update_ghost_values();
    }

  private:
    double
    acceleration_offset(const double v, const double a, const double dt) const
    {
      return -v / (beta * dt) - (0.5 / beta - 1.) * a;
    }

    double
    velocity_offset(const double v, const double a, const double dt) const
    {
      return (1. - gamma / beta) * v + dt * (1. - 0.5 * gamma / beta) * a;
    }

    const double alpha, beta, gamma;
  };
} // namespace seiche

#endif
