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
  StepSolver<dim>::StepSolver(const Scene<dim>         &run_scene,
                              const Formulation<dim>   &formulation,
                              const TimeScheme<dim>    &run_time_scheme,
                              const BodyForce<dim>     &body_force,
                              const WallMotion<dim>    &run_wall_motion,
                              const PointCloud<dim>    &points,
                              Occupancy<dim>           &run_occupancy,
                              const Fill<dim>          &run_fill,
                              const CellMaterials<dim> &materials,
                              RunReport                &run_report,
                              TimerTree                &run_timer)
    : scene(run_scene)
    , time_scheme(run_time_scheme)
    , wall_motion(run_wall_motion)
    , occupancy(run_occupancy)
    , fill(run_fill)
    , report(run_report)
    , timer(run_timer)
    , has_pressure(formulation.has_pressure())
    , is_incompressible(has_pressure && scene.fluid.is_incompressible())
    , measures_forces(scene.postprocessors.measure_forces())
    , quadrature(
        make_quadrature(points,
                        fill,
                        materials,
                        is_incompressible ? VolumeRatio::one :
                        scene.volume_update() == VolumeUpdate::at_the_point ?
                                            VolumeRatio::mean :
                                            VolumeRatio::linear))
    , wall_velocity(scene.grid, scene.input, scene.time.end_time)
    , wall_conditions(wall_velocity, wall_motion, occupancy)
    , dry_edges(occupancy)
    , row_mass(occupancy,
               measures_forces || scene.grid.any_friction() ||
                 scene.grid.any_unilateral())
    , wall_friction(occupancy, row_mass)
    , wall_contact(wall_conditions, occupancy, row_mass, body_force, materials)
    , matrix(occupancy, has_pressure)
    , assembler(formulation,
                *quadrature,
                fill,
                materials,
                body_force,
                scene.free_surface,
                timer)
    , linear_solver(scene.linear_solver, timer)
    , velocity_projection(assembler,
                          matrix,
                          linear_solver,
                          scene.linear_solver.projection_tolerance)
    , residual_projection(assembler, *quadrature, occupancy)
    , newton(scene.newton,
             scene.linear_solver.tolerance,
             assembler,
             residual_projection,
             matrix,
             linear_solver,
             wall_contact)
  {}

  template <int dim>
  void
  StepSolver<dim>::reinit()
  {
    occupancy.set_linear(fill.linear_cells());
    matrix.reinit(fill);
    row_mass.reinit();
    if (!time_scheme.needs_acceleration())
      {
        dry_edges.reinit();
        wall_friction.reinit();
      }
    inertia_offset.reinit(occupancy.vector_partitioner());
    rate_offset.reinit(occupancy.vector_partitioner());
  }

  template <int dim>
  void
  StepSolver<dim>::find_consistent_start(GridState<dim> &state)
  {
    wall_conditions.set_start_velocity(state);
    bool converged = true;
    if (has_pressure)
      converged =
        velocity_projection.apply(state, time_scheme.coefficients(state.dt))
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
    if (const std::string problem = problem_of_walls(state); !problem.empty())
      return problem;
    dry_edges.update(state);
    const StepCoefficients step = time_scheme.coefficients(state.dt);
    linear_solver.begin_step();
    if (const std::string problem = find_start_velocity(state, step, projects);
        !problem.empty())
      return problem;
    find_start_reaction(state, projects);
    {
      const TimerTree::Scope scope(timer, "newton");
      time_scheme.predict(state);
      if (const auto *closed = assembler.closed_chambers())
        {
          closed->level_pressure(state.solution.block(1));
          state.solution.update_ghost_values();
        }
      time_scheme.offsets(state, state.dt, inertia_offset, rate_offset);
      wall_conditions.set_displacement(state, step, rate_offset);
      wall_contact.begin_iteration(step, rate_offset);
      assembler.begin(step, state, inertia_offset, rate_offset);
      const unsigned int of_projection = last.krylov_iterations;
      const bool         accepts       = scene.time.accepts_failing_steps();
      last = newton.solve(state, if_unconverged(accepts, is_repeated));
      last.krylov_iterations += of_projection;
      if (!last.converged && !(accepts && last.is_usable))
        return last.failure;
    }
    time_scheme.finish(state);
    return "";
  }

  template <int dim>
  std::string
  StepSolver<dim>::problem_of_walls(const GridState<dim> &state) const
  {
    const double way = wall_way(state.time, state.dt);
    if (way > largest_wall_way * scene.time.maximum_displacement)
      return fmt::format("a wall moves by {:.3g} cells", way);
    if (wall_motion.any() && walls_squeeze_chamber(state))
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
    const ClosedChambers<dim> *closed = assembler.closed_chambers();
    if (closed == nullptr)
      return false;
    const auto &chambers = closed->chambers;
    const auto  lines    = [this](const double time) {
      return [this, time](const unsigned int direction, const double place) {
        return wall_motion.line(direction, place, time);
      };
    };
    for (unsigned int chamber = 0; chamber < chambers.size(); ++chamber)
      if (closed->is_closed(chamber))
        {
          const double before = chambers.volume(chamber, lines(state.time));
          const double after =
            chambers.volume(chamber, lines(state.time + state.dt));
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
    wall_contact.begin(state, assembler.closed_chambers());
    while (true)
      {
        wall_conditions.set_start_velocity(state);
        wall_friction.apply(state);
        if (!has_pressure || !projects)
          return "";
        const TimerTree::Scope scope(timer, "velocity projection");
        const LinearResult     result =
          velocity_projection.apply(state,
                                    coefficients,
                                    wall_contact.any() || measures_forces);
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
        if (!wall_contact.correct_start(state))
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
    occupancy.for_each_fixed([&](const unsigned int i) {
      // walls give their velocity first, then the projection pushes
      state.start_reaction.local_element(i) =
        wall_impulse(state, row_mass, i) +
        (has_pressure && projects ? state.reaction.local_element(i) : 0.);
    });
  }

  template <int dim>
  double
  StepSolver<dim>::wall_way(const double time, const double dt) const
  {
    return wall_motion.largest_way(time, dt) / occupancy.smallest_extent();
  }

  template class StepSolver<2>;
  template class StepSolver<3>;
} // namespace seiche
