// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_impulse.h>
#include <seiche/simulation/step_solver.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of the largest way of a point in a step, what a wall may move: the grid
    /// goes with it, and the sum of both counts.
    constexpr double largest_wall_way = 0.5;

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
    , has_pressure(problem.formulation->has_pressure())
    , measures_forces(problem.scene.postprocessors.measure_forces())
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
             problem.wall_contact)
  {}

  template <int dim>
  void
  StepSolver<dim>::find_consistent_start(GridState<dim> &state)
  {
    problem.wall_conditions.set_start_velocity(state);
    bool converged = true;
    if (has_pressure)
      converged = velocity_projection
                    .apply(state, problem.time_scheme->coefficients(state.dt))
                    .converged;
    converged =
      converged && velocity_projection.consistent_start(state).converged;
    if (!converged)
      throw NumericalError("The consistent start (velocity, acceleration and "
                           "pressure that satisfy the constraint) did not "
                           "converge; set Solver/Linear solver = direct.");
  }

  template <int dim>
  std::string
  StepSolver<dim>::solve(GridState<dim> &state,
                         const bool      projects,
                         const bool      is_repeated)
  {
    last = NewtonResult();
    if (const std::string failure = problem_of_walls(state); !failure.empty())
      return failure;
    problem.dry_edges.update(state);
    const StepCoefficients step = problem.time_scheme->coefficients(state.dt);
    linear_solver.begin_step();
    if (const std::string failure = find_start_velocity(state, step, projects);
        !failure.empty())
      return failure;
    find_start_reaction(state, projects);
    {
      const TimerTree::Scope scope(timer, "newton");
      problem.time_scheme->predict(state);
      if (const auto *closed = problem.assembler.closed_chambers())
        {
          closed->level_pressure(state.solution.block(1));
          state.solution.update_ghost_values();
        }
      inertia_offset.reinit(problem.occupancy.vector_partitioner());
      rate_offset.reinit(problem.occupancy.vector_partitioner());
      problem.time_scheme->offsets(state,
                                   state.dt,
                                   inertia_offset,
                                   rate_offset);
      problem.wall_conditions.set_displacement(state, step, rate_offset);
      problem.wall_contact.begin_iteration(step, rate_offset);
      problem.assembler.begin(step, state, inertia_offset, rate_offset);
      const unsigned int of_projection = last.krylov_iterations;
      const bool         accepts = problem.scene.time.accepts_failing_steps();
      last = newton.solve(state, if_unconverged(accepts, is_repeated));
      last.krylov_iterations += of_projection;
      if (!last.converged && !(accepts && last.is_usable))
        return last.failure;
    }
    problem.time_scheme->finish(state);
    return "";
  }

  template <int dim>
  std::string
  StepSolver<dim>::problem_of_walls(const GridState<dim> &state) const
  {
    const double way = problem.wall_way(state.time, state.dt);
    if (way > largest_wall_way * problem.scene.time.maximum_displacement)
      return fmt::format("a wall moves by {:.3g} cells", way);
    if (problem.wall_motion.any() && walls_squeeze_chamber(state))
      throw NumericalError(fmt::format(
        "t = {:.6g} s: walls change the volume of a chamber that is full of "
        "incompressible fluid, or counts as full: half a cell of air under a "
        "lid is not seen. Leave room above the fluid, choose smaller cells or "
        "open a wall.",
        state.time));
    return "";
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
            chambers.volume(chamber, problem.wall_motion.lines(state.time));
          const double after =
            chambers.volume(chamber,
                            problem.wall_motion.lines(state.time + state.dt));
          if (std::abs(after / before - 1.) > largest_volume_change)
            return true;
        }
    return false;
  }

  template <int dim>
  std::string
  StepSolver<dim>::find_start_velocity(GridState<dim>         &state,
                                       const StepCoefficients &coefficients,
                                       const bool              projects)
  {
    problem.wall_contact.begin(state, problem.assembler.closed_chambers());
    while (true)
      {
        problem.wall_conditions.set_start_velocity(state);
        problem.wall_friction.apply(state);
        if (!has_pressure || !projects)
          return "";
        const TimerTree::Scope scope(timer, "velocity projection");
        const LinearResult     result = velocity_projection.apply(
          state, coefficients, problem.wall_contact.any() || measures_forces);
        last.krylov_iterations += result.iterations;
        if (!result.is_usable(VelocityProjection<dim>::usable_reduction))
          return result.is_singular ?
                   result.problem() :
                   "the velocity projection did not converge";
        if (!result.converged)
          report.warn("a velocity projection stopped early",
                      fmt::format("t = {:.6g} s: {:.1e} of the violation is "
                                  "left",
                                  state.time,
                                  result.reduction));
        if (!problem.wall_contact.correct_start(state))
          return "";
      }
  }

  template <int dim>
  void
  StepSolver<dim>::find_start_reaction(GridState<dim> &state,
                                       const bool      projects) const
  {
    if (!measures_forces)
      return;
    state.start_reaction = 0.;
    problem.occupancy.for_each_fixed([&](const unsigned int i) {
      // walls give their velocity first, then the projection pushes
      state.start_reaction.local_element(i) =
        wall_impulse(state, problem.row_mass, i) +
        (has_pressure && projects ? state.reaction.local_element(i) : 0.);
    });
  }

  template class StepSolver<2>;
  template class StepSolver<3>;
} // namespace seiche
