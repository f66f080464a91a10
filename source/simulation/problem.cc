// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/problem.h>
#include <seiche/simulation/solids_on_grid.h>
#include <seiche/solve/solid_coupling.h>
#include <seiche/solve/tank_coupling.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// That of quadrature points which are no material ones.
    template <int dim>
    VolumeRatio
    volume_ratio(const Scene<dim> &scene)
    {
      if (scene.formulation.is_mixed() && scene.fluid.is_incompressible())
        return VolumeRatio::one;
      return scene.volume_update() == VolumeUpdate::at_the_point ?
               VolumeRatio::mean :
               VolumeRatio::linear;
    }

    template <int dim>
    bool
    needs_row_mass(const Scene<dim> &scene)
    {
      return scene.postprocessors.measure_forces() ||
             scene.grid.any_friction() || scene.grid.any_unilateral() ||
             scene.tank_motion.body.any();
    }
    /// Places of solids that the fluid moves: points are found outside of them.
    template <int dim>
    void
    load_free_solids(StateArchive &archive, std::vector<Solid<dim>> &solids)
    {
      unsigned int body = 0;
      for (Solid<dim> &solid : solids)
        if (solid.is_free())
          BodyCoupling<dim>::save_or_load_body(archive, body++, *solid.motion);
    }
  } // namespace

  template <int dim>
  Problem<dim>::Problem(const PlannedScene<dim> &planned,
                        TimerTree               &timer_tree,
                        const Checkpoint        *start,
                        const MPI_Comm           ranks)
    : scene(planned.scene)
    , timer(timer_tree)
    , communicator(ranks)
    , grid_motion(scene.grid, scene.time.end_time)
    , grid(scene.grid, communicator)
    , locator(grid)
    , time_scheme(make_time_scheme<dim>(scene.time_scheme,
                                        scene.fluid.is_incompressible()))
    , formulation(make_formulation<dim>(scene.formulation,
                                        scene.free_surface,
                                        scene.fluid.volume_law,
                                        time_scheme->volume_factors()))
    , points(locator, point_columns(), communicator)
    , seeding(fill_points(planned.bodies, start))
    , mesh_adaptation(grid, locator, points, scene.quadrature.has_surface())
    , occupancy(locator, scene.formulation.degree)
    , fill(occupancy, scene.quadrature.value(), scene.filled_volume())
    , materials(scene.materials, occupancy)
    , density_projection(fill, scene.point_control.density_rate)
    , point_control(scene.point_control, points, occupancy, fill)
    , transfer(scene.transfer, fill, materials, scene.volume_update())
    , tank_motion(scene.make_tank_motion())
    , body_force(scene.body_force, tank_motion, scene.input)
    , wall_conditions(occupancy)
    , convex_edges(occupancy)
    , row_mass(occupancy, needs_row_mass(scene))
    , wall_friction(occupancy, row_mass)
    , wall_contact(wall_conditions, occupancy, row_mass, body_force, materials)
    , bodies(make_bodies())
    , quadrature(make_quadrature(points, fill, materials, volume_ratio(scene)))
    , matrix(fill, formulation.has_pressure())
    , assembler(formulation,
                materials,
                body_force,
                *quadrature,
                matrix.sparsity(),
                timer)
  {
    if (start == nullptr) // they may have left it since
      require_solids_on_grid(occupancy, scene.input);
  }

  template <int dim>
  std::unique_ptr<BodyCoupling<dim>>
  Problem<dim>::make_bodies()
  {
    const double tolerance = scene.newton.tolerance;
    if (tank_motion.body() != nullptr)
      return std::make_unique<TankCoupling<dim>>(tank_motion,
                                                 occupancy,
                                                 tolerance);
    if (any_is_free(locator.solids))
      return std::make_unique<SolidCoupling<dim>>(
        occupancy, wall_conditions, body_force, materials, tolerance);
    return nullptr;
  }

  template <int dim>
  std::set<PointColumn>
  Problem<dim>::point_columns() const
  {
    auto columns = scene.point_columns();
    if (carries_acceleration())
      columns.insert(PointColumn::acceleration);
    return columns;
  }

  template <int dim>
  SeedingResult
  Problem<dim>::fill_points(const std::vector<FluidBody<dim>> &bodies,
                            const Checkpoint                  *start)
  {
    if (start == nullptr)
      return seed_bodies(
        scene.seeding, bodies, scene.input, scene.materials, points);
    double time = 0.;
    start->state().section("time", [&]() { start->state()("time", time); });
    if (grid_motion.any())
      locator.move(grid_motion, time);
    load_free_solids(start->state(), locator.solids);
    if (any_moves(locator.solids))
      locator.move_solids(time);
    start->insert_own_points(points);
    points.locate();
    if (points.n_global() != start->n_points())
      throw FileError(fmt::format("{}: {} of its {} points lie in no cell of "
                                  "the grid.",
                                  start->filename,
                                  start->n_points() - points.n_global(),
                                  start->n_points()));
    return SeedingResult(); // Simulation::save_or_load() fills it
  }

  template <int dim>
  void
  Problem<dim>::move_grid(const double time)
  {
    if (!grid_motion.any() && !any_moves(locator.solids))
      return;
    if (grid_motion.any()) // solids are at rest then: scene_check.cc
      locator.move(grid_motion, time);
    else
      locator.move_solids(time);
    occupancy.update_places();
  }

  template <int dim>
  void
  Problem<dim>::adapt_mesh(const unsigned int n_steps)
  {
    const TimerTree::Scope scope(timer, "mesh adaptation");
    if (n_steps > 0 && mesh_adaptation.update(n_steps))
      occupancy.reinit();
  }

  template <int dim>
  void
  Problem<dim>::find_cells()
  {
    const TimerTree::Scope scope(timer, "occupancy and fill");
    occupancy.update(points);
    fill.update(points);
  }

  template <int dim>
  void
  Problem<dim>::find_unknowns()
  {
    const TimerTree::Scope scope(timer, "pattern");
    materials.update(points);
    occupancy.set_linear(fill.linear_cells());
    matrix.reinit();
    row_mass.reinit(points);
    if (!time_scheme->needs_acceleration())
      {
        convex_edges.reinit();
        wall_friction.reinit();
      }
  }

  template <int dim>
  void
  Problem<dim>::points_to_grid(GridState<dim> &state) const
  {
    const TimerTree::Scope scope(timer, "points to grid");
    state.reinit(occupancy, formulation.has_pressure(), carries_acceleration());
    transfer.points_to_grid(points, state);
    if (!time_scheme->needs_acceleration())
      return;
    // the acceleration of the grid at walls is theirs
    occupancy.constraints.for_each_fixed(
      [&](const auto &direction) { direction.set(state.acceleration_n, 0.); });
    state.acceleration_n.update_ghost_values();
  }

  template <int dim>
  void
  Problem<dim>::update_points()
  {
    if (!formulation.has_pressure())
      formulation.update_pressures(points);
    else if (scene.volume_update() == VolumeUpdate::from_the_pressure)
      formulation.update_volume_ratios(points);
  }

  template <int dim>
  bool
  Problem<dim>::carries_acceleration() const
  {
    return time_scheme->needs_acceleration() || scene.time.controls_error();
  }

  template <int dim>
  double
  Problem<dim>::wall_way(const double time, const double dt) const
  {
    return std::max(grid_motion.largest_way(time, dt),
                    largest_way(locator.solids, scene.grid.domain(), dt)) /
           occupancy.smallest_extent();
  }

  template class Problem<2>;
  template class Problem<3>;
} // namespace seiche
