// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_step_solver_h
#define seiche_simulation_step_solver_h

#include <seiche/simulation/problem.h>
#include <seiche/simulation/run_report.h>
#include <seiche/solve/newton.h>
#include <seiche/solve/velocity_projection.h>
#include <seiche/utilities/timer_tree.h>

#include <cmath>

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

    // An attempt at the step of state.time and state.dt, in this order. Each
    // throws StepFailure if a smaller step may help. Collective.

    /// NumericalError if walls forbid steps of any size.
    void
    begin(GridState<dim> &state);

    /// state.velocity_start, which fits the walls and, if @p projects, the
    /// constraint; state.start_reaction, if forces are measured.
    void
    find_start_velocity(GridState<dim> &state, const bool projects);

    /// First guess of the solution, and what Newton's iteration starts with.
    void
    predict(GridState<dim> &state);

    /// Displacement and pressure. @p is_repeated: not the step's first attempt,
    /// so that Newton may take its time.
    void
    solve(GridState<dim> &state, const bool is_repeated);

    /// Local error of the step's displacements [cells], from @p previous_step
    /// [s]; 0 if it is of no use or unknown. Collective.
    double
    local_error(const GridState<dim> &state, const double previous_step) const;

    /// Iterations of the last attempt.
    const NewtonResult &
    newton_result() const
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
    /// True if the step would change the volume of a closed chamber.
    bool
    walls_squeeze_chamber(const GridState<dim> &state) const;

    /// The start velocity, which fits the walls, to the constraint as well.
    void
    project_start_velocity(GridState<dim> &state);

    /// state.start_reaction, if forces are measured. @p is_projected: what the
    /// walls give in the projection is in state.reaction.
    void
    find_start_reaction(GridState<dim> &state, const bool is_projected) const;

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
