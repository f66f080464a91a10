// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_newton_h
#define seiche_solve_newton_h

#include <seiche/grid/wall_contact.h>
#include <seiche/solve/body_coupling.h>
#include <seiche/solve/linear_system.h>
#include <seiche/solve/residual_projection.h>

#include <cmath>
#include <string>

namespace seiche
{
  /// prm entries of Newton's iteration (subsection "Solver").
  struct NewtonParameters
  {
    double       tolerance          = 1e-4;
    double       absolute_tolerance = 1e-9;
    unsigned int maximum_iterations = 12;

    void
    add_parameters(dealii::ParameterHandler &prm);
  };

  struct NewtonResult
  {
    bool         converged  = false;
    bool         is_usable  = false; ///< the finite iterate of least residual
    unsigned int iterations = 0;
    unsigned int krylov_iterations = 0;
    std::string  failure; ///< why not, for the log
  };

  /// What becomes of a step that does not converge.
  enum class IfUnconverged
  {
    give_up_early, ///< half of it costs less than many iterations
    give_up,
    take_nearest ///< the iterate of the least residual is taken
  };

  /**
   * @brief Newton's iteration with exact tangent and inexact linear solves.
   *
   * The residual of each field (momentum [N], volume [m^dim]) must fall below
   * tolerance times its first value, or below the absolute tolerance times
   * the forces (volumes) at work. Forcing terms: Eisenstat and Walker 1996,
   * choice 2, not below half of what the convergence test still needs, 0.3 at
   * most (doc/theory.md (10.1)). The tangent serves the next iteration as well
   * if the problem proved nearly linear. Updates that make the residual grow
   * are shortened. Two updates in a row that hardly reduce it end an iteration
   * that may give up early. The set of nodes that unilateral walls hold is
   * corrected after each update, the accelerations of bodies that the fluid
   * moves once it has converged.
   */
  template <int dim>
  class Newton
  {
  public:
    using BlockVector = typename GridState<dim>::BlockVector;

    /// @p first_forcing: what the first linear solve leaves of its residual; @p
    /// bodies that the fluid moves, or null.
    Newton(const NewtonParameters  &parameters,
           const double             first_forcing,
           const LinearSystem<dim> &system,
           ResidualProjection<dim> &projection,
           WallContact<dim>        &contact,
           BodyCoupling<dim>       *bodies);

    /// Solve for state.solution, starting at its value; assembler, contact
    /// and bodies have been begun for the step. state.reaction belongs to the
    /// solution. Collective.
    NewtonResult
    solve(GridState<dim> &state, const IfUnconverged then);

  private:
    struct Norms
    {
      double momentum = 0., volume = 0.;
    };

    Norms
    norms(const BlockVector &residual) const;

    /// Forces and volumes that the absolute tolerance refers to.
    Norms
    scales(const GridState<dim> &state) const;

    /// Add the update to the solution, or the largest half, quarter, ... of it
    /// that makes the residual fall below @p before, else a sixteenth; nothing
    /// then if @p only_nearer. The new residual's norm.
    double
    move(GridState<dim> &state, const double before, const bool only_nearer);

    /// What iterations hand on.
    struct Progress
    {
      Norms        first, now, target;  ///< of the residual
      double       forcing     = 0.;    ///< of the next linear solve
      unsigned int most_slow   = 0;     ///< updates in a row
      bool         may_reuse   = true;  ///< a tangent, in this try
      bool         reuse       = false; ///< the tangent, in the next iteration
      bool         reused      = false; ///< in the last one, to its end
      unsigned int slow_in_row = 0;     ///< updates
      unsigned int of_other_bodies = 0; ///< iterations, before its last one

      bool
      is_finite() const
      {
        return std::isfinite(now.momentum + now.volume);
      }

      /// Not of a residual that is not a number.
      bool
      is_done() const
      {
        return now.momentum <= target.momentum && now.volume <= target.volume;
      }

      /// Forget the updates so far: the problem is new.
      void
      begin(const double first_forcing)
      {
        forcing = first_forcing;
        reuse = reused = false;
        slow_in_row    = 0;
      }
    };

    /// What the residual must fall to, by what it is now or has been.
    void
    set_target(Progress &progress, const GridState<dim> &state) const;

    /// Residual of the state, and what it must fall to.
    Progress
    begin(GridState<dim> &state, const IfUnconverged then);

    /// An update of the solution and of its residual; result.failure says why
    /// there is none.
    void
    iterate(GridState<dim> &state,
            const bool      only_nearer,
            Progress       &progress,
            NewtonResult   &result);

    /// Norm of what the linear model of the last update missed.
    double
    model_error();

    /// After an update that left @p reduction of the residual @p before: what
    /// the next one is asked for.
    void
    plan_next(Progress &progress, const double reduction, const double before);

    /// Why the iteration must stop, or nothing.
    std::string
    reason_to_stop(const Progress    &progress,
                   const unsigned int iterations) const;

    const NewtonParameters   parameters;
    const double             first_forcing;
    const LinearSystem<dim>  system;
    ResidualProjection<dim> &projection;
    WallContact<dim>        &contact;
    BodyCoupling<dim>       *bodies; // null: none
    BlockVector              residual, update;
    BlockVector  residual_change; ///< new less old; A update if linear
    BlockVector  product;
    unsigned int tries_with_new_tangents = 0; ///< until one may be reused
  };
} // namespace seiche

#endif
