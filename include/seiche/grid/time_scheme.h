// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_time_scheme_h
#define seiche_grid_time_scheme_h

#include <seiche/grid/grid_state.h>

#include <memory>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief Scalars of a step that the weak forms need.
   *
   * Acceleration of the inertia term a = inertia u + inertia_offset, velocity
   * in the stress v = rate u + rate_offset, forces in the configuration
   * x_n + theta u, constraint at x_n + u: C_a, c_r, theta of doc/theory.md
   * (3.1).
   */
  struct StepCoefficients
  {
    double dt      = 0.; ///< [s]
    double theta   = 1.; ///< [-]
    double inertia = 0.; ///< [1/s^2]
    double rate    = 0.; ///< [1/s]
  };

  /// How a scheme takes the volume constraint [-].
  struct VolumeFactors
  {
    /// div v_0 = this dt tr(l l) fits the scheme: v_0 and v_1 then have the
    /// same divergence in their own configurations (doc/theory.md (3.3a)).
    double start_divergence = 0.;
    /// Of -dt^3 (3 tr(l grad a) - 2 tr(l^3)) = -dt^3 div(D^2v/Dt^2) in the
    /// constraint: v_1 then has no divergence (doc/theory.md (3.3)).
    double jerk = 0.;
    /// Time within the step of the strain in p = -kappa phi(J):
    /// J = J_n (1 + elastic_time (det f - 1)); 1 for infinite kappa.
    double elastic_time = 1.;
  };

  /// prm entries that choose and tune the scheme (subsection "Time").
  struct TimeSchemeParameters
  {
    std::string scheme           = "generalized midpoint";
    double      rho_infinity     = 1.;
    double      bossak_alpha     = -0.3;
    std::string pressure_order   = "second";
    std::string elastic_pressure = "end";

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @p is_incompressible: mixed form, infinite bulk modulus.
    void
    check(const InputFile &input, const bool is_incompressible) const;

    /// TimeScheme::needs_acceleration() of the scheme chosen.
    bool
    needs_acceleration() const;

    /// True if accelerations at points integrate to the scheme's velocities by
    /// Newmark's rule with gamma = 1/2.
    bool
    has_newmark_rule() const
    {
      return scheme == "newmark";
    }

    bool
    is_second_order() const
    {
      return needs_acceleration() || rho_infinity == 1.;
    }

    /// True if the volume ratio of the pressure is that of the step's end.
    bool
    is_elastic_at_end() const
    {
      return elastic_pressure == "end";
    }
  };

  /**
   * @brief Time integration of one step in terms of the displacement
   * increment u (doc/theory.md (3.1) and the table after it).
   */
  template <int dim>
  class TimeScheme
  {
  public:
    using Vector = typename GridState<dim>::Vector;

    virtual ~TimeScheme() = default;

    virtual StepCoefficients
    coefficients(const double dt) const = 0;

    virtual VolumeFactors
    volume_factors() const = 0;

    /// True if points carry an acceleration from step to step.
    virtual bool
    needs_acceleration() const = 0;

    /// Time within the step [0,1] at which forces and pressure live: the
    /// pressure belongs to t_n + pressure_time dt.
    virtual double
    pressure_time() const = 0;

    /// Local error of a step's displacement over dt^3 d^2v/dt^2, if the scheme
    /// is of second order.
    virtual double
    error_constant() const = 0;

    /// Nodal offsets of the coefficients from the start of the step
    /// (velocity_start, acceleration_n). Local on own and ghost nodes.
    virtual void
    offsets(const GridState<dim> &state,
            const double          dt,
            Vector               &inertia_offset,
            Vector               &rate_offset) const = 0;

    /// First guess: displacement dt v_start [m], pressure of the points [Pa].
    void
    predict(GridState<dim> &state) const;

    /// velocity_np1 and acceleration_np1 from the displacement; ghosts too.
    virtual void
    finish(GridState<dim> &state) const = 0;
  };

  /// The table of schemes: newmark, bossak, generalized midpoint.
  /// @p is_incompressible: infinite bulk modulus.
  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const TimeSchemeParameters &parameters,
                   const bool                  is_incompressible);
} // namespace seiche

#endif
