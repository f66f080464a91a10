// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_step_solver_h
#define seiche_simulation_step_solver_h

#include <seiche/simulation/problem.h>
#include <seiche/simulation/run_report.h>
#include <seiche/solve/newton.h>
#include <seiche/solve/velocity_projection.h>
#include <seiche/utilities/timer_tree.h>

#include <cmath>
#include <string>

namespace seiche
{
  /**
   * @brief The grid's part of a step: from the velocity of the points on the
   * grid to its displacement (and pressure) at the end of the step. Knows the
   * points only as quadrature.
   */
  template <int dim>
  class StepSolver
  {
  public:
    /// References must outlive this.
    StepSolver(Problem<dim> &problem, RunReport &report, TimerTree &timer);

    /// Velocity, acceleration and pressure that satisfy walls and constraint,
    /// in @p state, whose dt is that of the first step. NumericalError if they
    /// are not found. Collective.
    void
    find_consistent_start(GridState<dim> &state);

    /**
     * One attempt at the step of state.time and state.dt; empty, or why it
     * failed. @p projects: whether the start velocity is to satisfy the
     * constraint; @p is_repeated: not the step's first attempt, so that Newton
     * may take its time. Collective.
     */
    std::string
    solve(GridState<dim> &state, const bool projects, const bool is_repeated);

    /// Iterations of the last attempt.
    const NewtonResult &
    effort() const
    {
      return last;
    }

    /// Of the last attempt.
    const StepCoefficients &
    coefficients() const
    {
      return problem.assembler.coefficients();
    }

    /// One over the time [1/s] in which the body force of the last step moves
    /// fluid at rest by about a cell, sqrt(g/h). Collective.
    double
    fall_rate() const
    {
      return std::sqrt(problem.assembler.body_force_scale() /
                       problem.occupancy.smallest_extent());
    }

  private:
    /// Why the walls forbid the step; empty: they do not. NumericalError if no
    /// smaller step would help.
    std::string
    problem_of_walls(const GridState<dim> &state) const;

    /// True if the step would change the volume of a closed chamber.
    bool
    walls_squeeze_chamber(const GridState<dim> &state) const;

    /// Start velocity of a step that satisfies the walls and, if @p projects,
    /// the constraint; empty, or why not.
    std::string
    find_start_velocity(GridState<dim>         &state,
                        const StepCoefficients &coefficients,
                        const bool              projects);

    /// state.start_reaction, if forces are measured, once the start velocity
    /// is found.
    void
    find_start_reaction(GridState<dim> &state, const bool projects) const;

    using Vector = typename GridState<dim>::Vector;

    Problem<dim> &problem;
    RunReport    &report;
    TimerTree    &timer;

    const bool              has_pressure;
    const bool              measures_forces;
    LinearSolver<dim>       linear_solver;
    const LinearSystem<dim> system;
    VelocityProjection<dim> velocity_projection;
    ResidualProjection<dim> residual_projection;
    Newton<dim>             newton;
    Vector                  inertia_offset, rate_offset;
    NewtonResult            last;
  };
} // namespace seiche

#endif
