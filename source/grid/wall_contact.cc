// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_contact.h>
#include <seiche/grid/wall_impulse.h>
#include <seiche/space/shape_integrals.h>

#include <algorithm>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Tension that releases a node, over the forces at work at it: above what
    /// Newton's iteration leaves, so that a node does not change to and fro.
    constexpr double release_margin = 1e-3;

    /// Way into the wall, in cells, that counts as none.
    constexpr double penetration_margin = 1e-12;

    constexpr unsigned int most_releases = 2;

    /// Projections of a step; what then moves into a wall meets it in the step.
    constexpr unsigned int most_projections = 4;
  } // namespace

  template <int dim>
  WallContact<dim>::WallContact(const WallConditions<dim> &wall_conditions,
                                Occupancy<dim>            &grid_occupancy,
                                const RowMass<dim>        &grid_row_mass,
                                const BodyForce<dim>      &force,
                                const CellMaterials<dim>  &cell_materials)
    : conditions(wall_conditions)
    , occupancy(grid_occupancy)
    , row_mass(grid_row_mass)
    , body_force(force)
    , materials(cell_materials)
    , exists(grid_occupancy.locator.grid.parameters.any_unilateral())
  {}

  template <int dim>
  void
  WallContact<dim>::collect(const ClosedChambers<dim> *closed)
  {
    const auto &locator = occupancy.locator;
    contacts.clear();
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      if (closed == nullptr || !closed->holds_node(node))
        occupancy.constraints.for_each_held(
          node,
          [&](const WallDirection<dim> &direction,
              const unsigned int        components) {
            bool         unilateral = true;
            unsigned int sides      = 0; // an oblique normal points inwards
            double       extent     = std::numeric_limits<double>::max();
            double       width      = extent;
            for (const auto &entry : occupancy.constraints.walls_at(node))
              if ((components >> entry.component) & 1u)
                {
                  unilateral =
                    unilateral && locator.grid.wall(entry.wall).condition ==
                                    WallCondition::unilateral;
                  sides |= direction.component == dim ? 1u : entry.sides;
                  const double edge =
                    locator.cells.geometry(entry.cell).edges[entry.component];
                  extent = std::min(extent, edge);
                  width =
                    std::min(width,
                             line_integrals(occupancy.degree(entry.cell))[0] *
                               edge);
                }
            if (unilateral && (sides == 1u || sides == 2u))
              contacts.push_back({direction,
                                  sides == 1u ? 1. : -1.,
                                  extent,
                                  width,
                                  /*pressing=*/0.,
                                  /*margin=*/0.,
                                  /*releases=*/0});
          });
  }

  template <int dim>
  void
  WallContact<dim>::begin(const GridState<dim>      &state,
                          const ClosedChambers<dim> *closed)
  {
    projections = 0;
    if (!exists)
      return;
    collect(closed);
    for (Contact &contact : contacts)
      {
        const unsigned int node  = contact.direction.node;
        const double       mass  = row_mass.value(state, node);
        double             speed = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          speed += std::pow(state.velocity_n.local_element(dim * node + c), 2);
        contact.margin =
          release_margin * mass *
          (std::sqrt(speed) / state.dt +
           body_force.value(occupancy.nodes.position(node), state.time).norm());
        contact.pressing =
          std::max(0., state.pressure_guess.local_element(node)) *
          materials.volume_of_node(node, mass) / contact.width;
        contact.releases = 0;
        const double velocity =
          contact.inward *
          (contact.direction.of(state.velocity_n) -
           conditions.velocity(contact.direction, state.time, state.dt));
        occupancy.constraints.set_released(contact.direction,
                                           mass * velocity / state.dt >
                                             contact.pressing + contact.margin);
      }
    occupancy.constraints.share();
  }

  template <int dim>
  bool
  WallContact<dim>::change(Contact     &contact,
                           const double force,
                           const double way)
  {
    const bool fixed = occupancy.constraints.is_fixed(contact.direction);
    const bool release =
      fixed && force < -contact.margin && contact.releases < most_releases;
    const bool fix = !fixed && way < -penetration_margin * contact.extent;
    if (!release && !fix)
      return false;
    contact.releases += release;
    occupancy.constraints.set_released(contact.direction, release);
    return true;
  }

  template <int dim>
  bool
  WallContact<dim>::agree(const bool changed)
  {
    const MPI_Comm communicator =
      occupancy.nodes.partitioner()->get_mpi_communicator();
    if (Utilities::MPI::max(changed ? 1 : 0, communicator) == 0)
      return false;
    occupancy.constraints.share();
    return true;
  }

  template <int dim>
  bool
  WallContact<dim>::correct_start(const GridState<dim> &state)
  {
    if (!exists || ++projections == most_projections)
      return false;
    bool changed = false;
    for (Contact &contact : contacts)
      {
        const WallDirection<dim> &direction = contact.direction;
        // the projection began with the wall's velocity
        const double force =
          contact.inward * (direction.of(state.reaction) +
                            wall_impulse(state, row_mass, direction)) +
          contact.pressing;
        changed =
          change(contact,
                 force,
                 contact.inward *
                   (direction.of(state.velocity_start) -
                    conditions.velocity(direction, state.time, state.dt)) *
                   state.dt) ||
          changed;
      }
    return agree(changed);
  }

  template <int dim>
  void
  WallContact<dim>::begin_iteration(const StepCoefficients &step,
                                    const Vector           &offset)
  {
    coefficients = step;
    rate_offset  = &offset;
    for (Contact &contact : contacts)
      contact.releases = 0;
  }

  template <int dim>
  bool
  WallContact<dim>::correct(GridState<dim> &state)
  {
    if (!exists)
      return false;
    bool changed = false;
    for (Contact &contact : contacts)
      {
        const WallDirection<dim> &direction = contact.direction;
        const double              at_wall =
          conditions.displacement(direction, state, coefficients, *rate_offset);
        const double u = direction.of(state.displacement());
        if (change(contact,
                   contact.inward * direction.of(state.reaction),
                   contact.inward * (u - at_wall)))
          {
            changed = true;
            if (occupancy.constraints.is_fixed(direction))
              direction.set(state.displacement(), at_wall);
          }
      }
    if (!agree(changed))
      return false;
    state.solution.update_ghost_values();
    return true;
  }

  template class WallContact<2>;
  template class WallContact<3>;
} // namespace seiche
