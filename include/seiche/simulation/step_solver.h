// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_step_solver_h
#define seiche_simulation_step_solver_h

#include <seiche/grid/dry_edges.h>
#include <seiche/grid/wall_contact.h>
#include <seiche/grid/wall_friction.h>
#include <seiche/simulation/run_report.h>
#include <seiche/simulation/scene.h>
#include <seiche/solve/velocity_projection.h>
#include <seiche/utilities/timer_tree.h>

#include <cmath>
#include <memory>
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
    /// References must outlive this. Walls that let go of the fluid are noted
    /// in @p occupancy.
    StepSolver(const Scene<dim>         &scene,
               const Formulation<dim>   &formulation,
               const TimeScheme<dim>    &time_scheme,
               const BodyForce<dim>     &body_force,
               const WallMotion<dim>    &wall_motion,
               const PointCloud<dim>    &points,
               Occupancy<dim>           &occupancy,
               const Fill<dim>          &fill,
               const CellMaterials<dim> &materials,
               RunReport                &report,
               TimerTree                &timer);

    /// After a change of the fill: pattern of the matrix, faces of obstacles
    /// that have fluid at them. Collective.
    void
    reinit();

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

    /// Of the step that solve() has done, before its points move. Collective.
    StepBalance<dim>
    balance(const GridState<dim> &state)
    {
      return assembler.balance(state);
    }

    /// True if walls move and so may give energy to the fluid.
    bool
    walls_move() const
    {
      return wall_motion.any() || wall_velocity.any();
    }

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
      return assembler.coefficients();
    }

    /// Cells that sides of the domain move by in a step that starts at @p time
    /// [s] and has size @p dt [s].
    double
    wall_way(const double time, const double dt) const;

    /// One over the time [1/s] in which the body force of the last step moves
    /// fluid at rest by about a cell, sqrt(g/h). Collective.
    double
    fall_rate() const
    {
      return std::sqrt(assembler.body_force_scale() /
                       occupancy.smallest_extent());
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

    const Scene<dim>      &scene;
    const TimeScheme<dim> &time_scheme;
    const WallMotion<dim> &wall_motion;
    Occupancy<dim>        &occupancy;
    const Fill<dim>       &fill;
    RunReport             &report;
    TimerTree             &timer;

    const bool has_pressure;
    const bool is_incompressible; ///< constraint instead of a bulk modulus
    const bool measures_forces;
    const std::unique_ptr<Quadrature<dim>> quadrature;
    const WallVelocity<dim>                wall_velocity;
    const WallConditions<dim>              wall_conditions;
    DryEdges<dim>                          dry_edges;
    RowMass<dim>                           row_mass;
    WallFriction<dim>                      wall_friction;
    WallContact<dim>                       wall_contact;
    BlockMatrix<dim>                       matrix;
    Assembler<dim>                         assembler;
    LinearSolver<dim>                      linear_solver;
    VelocityProjection<dim>                velocity_projection;
    ResidualProjection<dim>                residual_projection;
    Newton<dim>                            newton;
    Vector                                 inertia_offset, rate_offset;
    NewtonResult                           last;
  };
} // namespace seiche

#endif
