// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_velocity_projection_h
#define seiche_solve_velocity_projection_h

#include <seiche/solve/linear_system.h>

namespace seiche
{
  /**
   * @brief Makes the start velocity of a step satisfy the discrete
   * incompressibility constraint.
   *
   * One linear solve of the step's own system with C_a = 1/dt^2, no body force,
   * no viscosity, at u = p = 0, the ghost penalty on accelerations: v_0 = u/dt
   * (doc/theory.md, "Projection of the start velocity"; div v_0 of theta > 1/2:
   * (3.3a)). Forces stay in the configuration x_n (theta = 0): at u = 0 the
   * subscale residual is rho v_0/dt, and its geometric derivative would add the
   * convective acceleration to the constraint. Without it the midpoint scheme
   * repeats every violation in v_0 with factor -rho_inf, which costs pressure
   * noise 2 rho h dv/dt.
   */
  template <int dim>
  class VelocityProjection
  {
  public:
    /// References must outlive the object.
    VelocityProjection(const LinearSystem<dim> &system, const double tolerance);

    /// A projection that stops early but has reduced the violation this much
    /// may be used: the step deals with the rest, and a shorter step would not
    /// help, because the system does not depend on dt.
    static constexpr double usable_reduction = 0.1;

    /// state.velocity_start from state.velocity_n; ghosts too. The solution of
    /// the state is overwritten.
    /// @p with_reactions: also state.reaction = (impulse of the walls)/dt, from
    /// the velocity that the walls have given to what they fix.
    /// Collective.
    LinearResult
    apply(GridState<dim> &state, const bool with_reactions = false);

    /**
     * Consistent start of schemes that carry an acceleration: a_0 and p_0
     * from M a_0 + B^T p_0 = f and div a_0 = tr(l l), l = grad v_0, the second
     * time derivative of J = 1 (doc/theory.md (3.6)). Into
     * state.acceleration_n and state.pressure_guess. Collective.
     */
    LinearResult
    consistent_start(GridState<dim> &state);

  private:
    using Vector      = typename GridState<dim>::Vector;
    using BlockVector = typename GridState<dim>::BlockVector;

    /// True if there is nothing to solve for.
    bool
    is_round_off(const BlockVector    &violation,
                 const Vector         &inertia_offset,
                 const GridState<dim> &state) const;

    /// Solve the linear system, starting from @p solution, until the residual
    /// has fallen by @p reduction. Components that walls fix keep their value.
    LinearResult
    solve(const WeakForm<dim>    &weak_form,
          GridState<dim>         &state,
          const StepCoefficients &coefficients,
          const Vector           &inertia_offset,
          const Vector           &rate_offset,
          BlockVector            &solution,
          const double            reduction);

    /// state.reaction of the system that solve() has just solved.
    void
    find_reactions(GridState<dim> &state, const BlockVector &solution);

    const LinearSystem<dim> system;
    const double            tolerance;
  };
} // namespace seiche

#endif
