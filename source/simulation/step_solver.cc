// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_impulse.h>
#include <seiche/simulation/step_failure.h>
#include <seiche/simulation/step_solver.h>
#include <seiche/solve/displacement_error.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Relative change of a full box in a step that is round-off.
    constexpr double largest_volume_change = 1e-10;

    IfUnconverged
    if_unconverged(const bool accepts_failing_steps, const bool is_repeated)
    {
      if (accepts_failing_steps)
        return IfUnconverged::take_nearest;
      return is_repeated ? IfUnconverged::give_up :
                           IfUnconverged::give_up_early;
    }
  } // namespace

  template <int dim>
  StepSolver<dim>::StepSolver(Problem<dim> &run_problem,
                              RunReport    &run_report,
                              TimerTree    &run_timer)
    : problem(run_problem)
    , report(run_report)
    , timer(run_timer)
    , has_pressure(problem.formulation.has_pressure())
    , measures_forces(problem.scene.postprocessors.measure_forces() ||
                      any_moves(problem.locator.solids) ||
                      problem.bodies != nullptr)
    , linear_solver(problem.scene.linear_solver, timer)
    , system{problem.assembler, problem.matrix, linear_solver}
    , velocity_projection(system,
                          problem.scene.linear_solver.projection_tolerance)
    , residual_projection(problem.assembler,
                          *problem.quadrature,
                          problem.occupancy)
    , newton(problem.scene.newton,
             problem.scene.linear_solver.tolerance,
             system,
             residual_projection,
             problem.wall_contact,
             problem.bodies.get())
  {}

  template <int dim>
  void
  StepSolver<dim>::find_consistent_start(GridState<dim> &state)
  {
    problem.wall_conditions.set_start_velocity(state);
    bool converged = true;
    if (has_pressure)
      converged = velocity_projection.apply(state).converged;
    converged =
      converged && velocity_projection.consistent_start(state).converged;
    if (!converged)
      throw NumericalError("The consistent start (velocity, acceleration and "
                           "pressure that satisfy the constraint) did not "
                           "converge; set Solver/Linear solver = direct.");
  }

  template <int dim>
  void
  StepSolver<dim>::begin(GridState<dim> &state)
  {
    last = NewtonResult();
    if (problem.bodies != nullptr)
      problem.bodies->begin(state);
    const double     way       = problem.wall_way(state.time, state.dt);
    constexpr double round_off = 1e-6;
    if (way > (1. + round_off) * problem.most_wall_way())
      throw StepFailure(fmt::format("a wall moves by {:.3g} cells", way));
    if (problem.grid_motion.any() && walls_squeeze_chamber(state))
      throw NumericalError(fmt::format(
        "t = {:.6g} s: walls change the volume of a chamber that is full of "
        "incompressible fluid, or counts as full: half a cell of air under a "
        "lid is not seen. Leave room above the fluid, choose smaller cells or "
        "open a wall.",
        state.time));
    problem.convex_edges.update(state);
    linear_solver.begin_step();
  }

  template <int dim>
  bool
  StepSolver<dim>::walls_squeeze_chamber(const GridState<dim> &state) const
  {
    const ClosedChambers<dim> *closed = problem.assembler.closed_chambers();
    if (closed == nullptr)
      return false;
    const auto &chambers = closed->chambers;
    for (unsigned int chamber = 0; chamber < chambers.size(); ++chamber)
      if (closed->is_closed(chamber))
        {
          const double before =
            chambers.volume(chamber, problem.grid_motion.lines(state.time));
          const double after =
            chambers.volume(chamber,
                            problem.grid_motion.lines(state.time + state.dt));
          if (std::abs(after / before - 1.) > largest_volume_change)
            return true;
        }
    return false;
  }

  template <int dim>
  void
  StepSolver<dim>::find_start_velocity(GridState<dim> &state,
                                       const bool      projects)
  {
    const bool is_projected = has_pressure && projects;
    problem.wall_contact.begin(state, problem.assembler.closed_chambers());
    do // until the walls hold what the projection presses on them
      {
        problem.wall_conditions.set_start_velocity(state);
        problem.wall_friction.apply(state);
        if (is_projected)
          project_start_velocity(state);
      }
    while (is_projected && problem.wall_contact.correct_start(state));
    find_start_reaction(state, is_projected);
  }

  template <int dim>
  void
  StepSolver<dim>::project_start_velocity(GridState<dim> &state)
  {
    const TimerTree::Scope scope(timer, "velocity projection");
    const LinearResult     result =
      velocity_projection.apply(state,
                                problem.wall_contact.any() || measures_forces);
    last.krylov_iterations += result.iterations;
    if (!result.is_usable(VelocityProjection<dim>::usable_reduction))
      throw StepFailure(result.is_singular ?
                          result.problem() :
                          "the velocity projection did not converge");
    if (!result.converged)
      report.warn("a velocity projection stopped early",
                  fmt::format("t = {:.6g} s: {:.1e} of the violation is left",
                              state.time,
                              result.reduction));
  }

  template <int dim>
  void
  StepSolver<dim>::find_start_reaction(GridState<dim> &state,
                                       const bool      is_projected) const
  {
    if (!measures_forces)
      return;
    state.solid_start_reactions.clear();
    if (is_projected)
      {
        state.start_reaction        = state.reaction;
        state.solid_start_reactions = state.solid_reactions;
      }
    else
      state.start_reaction = 0.;
    add_wall_impulses(problem.row_mass, problem.occupancy, state);
  }

  template <int dim>
  void
  StepSolver<dim>::predict(GridState<dim> &state)
  {
    const TimeScheme<dim> &scheme = *problem.time_scheme;
    const StepCoefficients step   = scheme.coefficients(state.dt);
    scheme.predict(state);
    if (const auto *closed = problem.assembler.closed_chambers())
      {
        closed->level_pressure(state.solution.block(1));
        state.solution.update_ghost_values();
      }
    inertia_offset.reinit(problem.occupancy.nodes.vector_partitioner());
    rate_offset.reinit(problem.occupancy.nodes.vector_partitioner());
    scheme.offsets(state, state.dt, inertia_offset, rate_offset);
    problem.wall_conditions.set_displacement(state, step, rate_offset);
    problem.wall_contact.begin_iteration(step, rate_offset);
    if (problem.bodies != nullptr)
      problem.bodies->begin_iteration(step);
    problem.assembler.begin(
      *problem.formulation.step, step, state, inertia_offset, rate_offset);
  }

  template <int dim>
  void
  StepSolver<dim>::solve(GridState<dim> &state, const bool is_repeated)
  {
    const bool         accepts = problem.scene.time.accepts_failing_steps();
    const unsigned int of_projection = last.krylov_iterations;
    last = newton.solve(state, if_unconverged(accepts, is_repeated));
    last.krylov_iterations += of_projection;
    if (!last.converged && !(accepts && last.is_usable))
      throw StepFailure(last.failure);
  }

  template <int dim>
  double
  StepSolver<dim>::local_error(const GridState<dim> &state,
                               const double          previous_step) const
  {
    if (!problem.scene.time.controls_error() || previous_step == 0.)
      return 0.;
    const TimeScheme<dim> &scheme = *problem.time_scheme;
    const double           lag    = scheme.pressure_time();
    return displacement_error(state,
                              problem.occupancy.constraints,
                              scheme.error_constant(),
                              lag * state.dt + (1. - lag) * previous_step) /
           problem.occupancy.smallest_extent();
  }

  template class StepSolver<2>;
  template class StepSolver<3>;
} // namespace seiche
