// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/solid_coupling.h>
#include <seiche/solve/solid_stops.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// What a force on an arm does along a direction: itself, or its moment.
    template <int dim>
    double
    load_along(const BodyDirection<dim> &way,
               const Tensor<1, dim>     &arm,
               const Tensor<1, dim>     &force)
    {
      return way.is_angle() ? moment(arm, force)[way.number - dim] :
                              force[way.number];
    }

    template <int dim>
    std::vector<RigidMotion<dim> *>
    free_motions(const std::vector<Solid<dim>> &solids)
    {
      std::vector<RigidMotion<dim> *> result;
      for (const Solid<dim> &solid : solids)
        if (solid.is_free())
          result.push_back(solid.motion.get());
      return result;
    }
  } // namespace

  template <int dim>
  SolidCoupling<dim>::SolidCoupling(const Occupancy<dim>      &grid_occupancy,
                                    const WallConditions<dim> &conditions,
                                    const BodyForce<dim>      &force,
                                    const CellMaterials<dim>  &cell_materials,
                                    const double               of_balance)
    : BodyCoupling<dim>(free_motions(grid_occupancy.locator.solids),
                        grid_occupancy,
                        of_balance)
    , wall_conditions(conditions)
    , body_force(force)
    , materials(cell_materials)
  {
    const auto &solids = grid_occupancy.locator.solids;
    for (unsigned int s = 0; s < solids.size(); ++s)
      if (solids[s].is_free())
        solid_of_body.push_back(s);
  }

  template <int dim>
  std::vector<typename SolidCoupling<dim>::AddedInertia>
  SolidCoupling<dim>::added_inertias(const GridState<dim> &state) const
  {
    const auto &locator = occupancy.locator;
    const auto &walls   = occupancy.mesh_nodes.cut_walls;
    const auto &solids  = locator.solids;
    // of what they displace: mass, and for each direction the inertia
    const unsigned int  n = solids.size();
    std::vector<double> sums(n + directions.size(), 0.);
    const double        density = materials.largest().density;
    const auto          about   = centres(state.time + step.theta * state.dt);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const double share = 1. - walls.wet_share(cell);
        if (!(share > 0.))
          continue;
        const CellGeometry<dim> &geometry = locator.cells.geometry(cell);
        const Point<dim>         x        = geometry.box().center();
        const unsigned int solid = nearest_solid(solids, x) - solids.data();
        const double       mass  = density * share * geometry.measure;
        sums[solid] += mass;
        for (unsigned int i = 0; i < directions.size(); ++i)
          if (solid_of_body[directions[i].body] == solid)
            {
              Tensor<1, dim> arm = x - about[i];
              if (dim == 3)
                arm[directions[i].way.axis()] = 0.;
              sums[n + i] +=
                mass * (directions[i].way.is_angle() ? arm.norm_square() : 1.);
            }
      }
    Utilities::MPI::sum(sums, state.mass.get_mpi_communicator(), sums);
    std::vector<AddedInertia> result;
    for (unsigned int i = 0; i < directions.size(); ++i)
      result.push_back({sums[n + i], sums[solid_of_body[directions[i].body]]});
    return result;
  }

  template <int dim>
  Point<dim>
  SolidCoupling<dim>::centre(const Direction &direction,
                             const double     time) const
  {
    const RigidMotion<dim> &motion = *direction.motion;
    return motion.at(time).place(motion.centre);
  }

  template <int dim>
  std::vector<Point<dim>>
  SolidCoupling<dim>::centres(const double time) const
  {
    std::vector<Point<dim>> result;
    for (const Direction &direction : directions)
      result.push_back(centre(direction, time));
    return result;
  }

  template <int dim>
  std::vector<double>
  SolidCoupling<dim>::fluid_loads(const GridState<dim> &state) const
  {
    std::vector<double> loads(directions.size(), 0.);
    const auto          about = centres(state.time + step.theta * state.dt);
    state.for_each_solid_reaction([&](const auto &reaction) {
      for (unsigned int i = 0; i < loads.size(); ++i)
        if (solid_of_body[directions[i].body] == reaction.solid)
          loads[i] -= load_along<dim>(directions[i].way,
                                      reaction.place - about[i],
                                      reaction.force);
    });
    Utilities::MPI::sum(loads, state.mass.get_mpi_communicator(), loads);
    return loads;
  }

  template <int dim>
  std::vector<BodyStop>
  SolidCoupling<dim>::find_stops(const GridState<dim> &state) const
  {
    const auto places = solids_nearby(occupancy, state.time);
    if (places.empty())
      return {};
    const auto                &solids = occupancy.locator.solids;
    const auto                 about  = centres(state.time);
    std::vector<RigidWay<dim>> velocities;
    for (const Solid<dim> &solid : solids)
      velocities.push_back(solid.velocity());
    std::vector<BodyStop> result;
    for (const SolidNearby<dim> &nearby : places)
      {
        const bool at_wall     = nearby.other == numbers::invalid_unsigned_int;
        double     restitution = solids[nearby.solid].restitution;
        if (!at_wall)
          restitution = std::max(restitution, solids[nearby.other].restitution);
        BodyStop       stop;
        Tensor<1, dim> relative = velocities[nearby.solid].at(nearby.place);
        if (!at_wall) // walls of the grid do not move across themselves
          relative -= velocities[nearby.other].at(nearby.place);
        stop.rate  = nearby.normal * relative;
        stop.least = -restitution * std::min(0., stop.rate);
        for (unsigned int i = 0; i < directions.size(); ++i)
          {
            const unsigned int solid = solid_of_body[directions[i].body];
            const double       sign  = solid == nearby.solid ? 1. :
                                       solid == nearby.other ? -1. :
                                                               0.;
            // a unit of an angle moves the place by its moment
            stop.way.push_back(sign * load_along<dim>(directions[i].way,
                                                      nearby.place - about[i],
                                                      nearby.normal));
          }
        result.push_back(std::move(stop));
      }
    return result;
  }

  template <int dim>
  double
  SolidCoupling<dim>::further_load(const Direction      &direction,
                                   const GridState<dim> &state) const
  {
    return weight(direction, state) + mooring_load(direction, state);
  }

  template <int dim>
  double
  SolidCoupling<dim>::weight(const Direction      &direction,
                             const GridState<dim> &state) const
  {
    if (direction.way.is_angle()) // the centre is that of mass
      return 0.;
    const double time = state.time + step.theta * state.dt;
    return direction.motion->body()->inertia(direction.number) *
           body_force.value(centre(direction, time),
                            time)[direction.way.number];
  }

  template <int dim>
  double
  SolidCoupling<dim>::mooring_load(const Direction      &direction,
                                   const GridState<dim> &state) const
  {
    const auto &solids = occupancy.locator.solids;
    const auto &list   = solids[solid_of_body[direction.body]].moorings;
    if (list.empty())
      return 0.;
    const double         middle = state.time + 0.5 * state.dt;
    const Placement<dim> body   = direction.motion->at(middle);
    const Point<dim>     about  = centre(direction, middle);
    double               result = 0.;
    for (const Mooring<dim> &mooring : list)
      result += load_along<dim>(direction.way,
                                body.place(mooring.fairlead) - about,
                                mooring.force(body));
    return result;
  }

  template <int dim>
  void
  SolidCoupling<dim>::apply(GridState<dim> &state) const
  {
    wall_conditions.set_ways_of_solids(state, step.theta);
  }

  template class SolidCoupling<2>;
  template class SolidCoupling<3>;
} // namespace seiche
