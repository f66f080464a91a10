// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_problem_h
#define seiche_simulation_problem_h

#include <seiche/grid/convex_edges.h>
#include <seiche/grid/density_projection.h>
#include <seiche/grid/mesh_adaptation.h>
#include <seiche/grid/point_control.h>
#include <seiche/grid/wall_contact.h>
#include <seiche/grid/wall_friction.h>
#include <seiche/simulation/checkpoint.h>
#include <seiche/simulation/planned_scene.h>
#include <seiche/solve/assembler.h>
#include <seiche/solve/body_coupling.h>
#include <seiche/utilities/timer_tree.h>

#include <memory>
#include <set>

namespace seiche
{
  /**
   * @brief The objects of the method on one scene, made here in the order in
   * which they need one another: for a run, for the kernels' benchmarks, for
   * tests.
   *
   * They hold what the scene is and where its material points are; the grid's
   * fields of a step are in a GridState, how a step goes is told by
   * Simulation::advance().
   */
  template <int dim>
  class Problem
  {
  public:
    /// Build the grid and fill it, with the bodies of the scene or the points
    /// of a checkpoint. References must outlive the object. Throws InputError.
    /// Collective.
    Problem(const PlannedScene<dim> &planned,
            TimerTree               &timer,
            const Checkpoint        *start        = nullptr,
            const MPI_Comm           communicator = MPI_COMM_WORLD);

    /// Sides of the domain, and the grid with them, or solids to where they are
    /// at @p time [s]. Collective.
    void
    move_grid(const double time);

    /// Cells as fine as located points want them after this number of steps.
    /// Collective.
    void
    adapt_mesh(const unsigned int n_steps);

    /// Occupied cells and fill, from located points. Collective.
    void
    find_cells();

    /// What else follows from the cells: their materials and degrees, pattern
    /// of the matrix, walls that have fluid at them. Collective.
    void
    find_unknowns();

    /// Fields of the points at the nodes, all others zero. Collective.
    void
    points_to_grid(GridState<dim> &state) const;

    /// What the formulation keeps at the points, from what grid to points has
    /// left there. Local.
    void
    update_points();

    /// True if the points keep the acceleration of the step before.
    bool
    carries_acceleration() const;

    /// True if walls move and so may give energy to the fluid.
    bool
    walls_move() const
    {
      return scene.grid.any_moving() || any_moves(locator.solids);
    }

    /// Cells that sides of the domain or solids move by in a step from @p time
    /// [s] of size @p dt [s].
    double
    wall_way(const double time, const double dt) const;

    /// What it may be in a step: half of what a point may, for the grid goes
    /// with the wall and the sum of both counts.
    double
    most_wall_way() const
    {
      return 0.5 * scene.time.maximum_displacement;
    }

    const Scene<dim> &scene;
    TimerTree        &timer;
    const MPI_Comm    communicator;

    // grid and material points
    const GridMotion<dim> grid_motion;
    BackgroundGrid<dim>   grid;
    CellLocator<dim>      locator;

    const std::unique_ptr<const TimeScheme<dim>> time_scheme;
    const Formulation<dim>                       formulation;

    PointCloud<dim>     points;
    SeedingResult       seeding;
    MeshAdaptation<dim> mesh_adaptation;

    // occupied cells
    Occupancy<dim>         occupancy;
    Fill<dim>              fill;
    CellMaterials<dim>     materials;
    DensityProjection<dim> density_projection;
    PointControl<dim>      point_control;
    const Transfer<dim>    transfer;

    // what acts on the fluid
    TankMotion<dim>           tank_motion;
    const BodyForce<dim>      body_force;
    const WallConditions<dim> wall_conditions;
    ConvexEdges<dim>          convex_edges;
    RowMass<dim>              row_mass;
    WallFriction<dim>         wall_friction;
    WallContact<dim>          wall_contact;
    /// Of what the fluid moves; null: nothing.
    const std::unique_ptr<BodyCoupling<dim>> bodies;

    // equations
    const std::unique_ptr<const Quadrature<dim>> quadrature;
    BlockMatrix<dim>                             matrix;
    Assembler<dim>                               assembler;

  private:
    std::unique_ptr<BodyCoupling<dim>>
    make_bodies();

    std::set<PointColumn>
    point_columns() const;

    /// The points of the start, or of the scene's bodies. Collective.
    SeedingResult
    fill_points(const std::vector<FluidBody<dim>> &bodies,
                const Checkpoint                  *start);
  };
} // namespace seiche

#endif
