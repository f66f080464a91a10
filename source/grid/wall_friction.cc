// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_friction.h>
#include <seiche/space/shape_integrals.h>

#include <deal.II/base/geometry_info.h>

#include <map>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  WallFriction<dim>::WallFriction(const Occupancy<dim> &grid_occupancy,
                                  const RowMass<dim>   &grid_row_mass)
    : occupancy(grid_occupancy)
    , exists(grid_occupancy.locator.grid.parameters.any_friction())
    , row_mass(grid_row_mass)
  {}

  template <int dim>
  void
  WallFriction<dim>::reinit()
  {
    contacts.clear();
    if (!exists)
      return;
    const auto                   &locator = occupancy.locator;
    const std::vector<Wall<dim>> &walls   = locator.grid.parameters.walls;
    const auto                   &line    = line_integrals(occupancy.fe.degree);
    const Vector                  zero(occupancy.nodes.partitioner());

    Vector volume(zero);
    // the same walls on every rank
    std::map<std::pair<unsigned int, unsigned int>, Vector> areas;
    for (unsigned int wall = 0; wall < walls.size(); ++wall)
      for (unsigned int d = 0; d < dim; ++d)
        if (walls[wall].friction > 0. &&
            (!walls[wall].is_side() || walls[wall].side().direction() == d))
          areas.emplace(std::make_pair(wall, d), zero);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (!touches_wall(occupancy, cell))
          continue;
        add_volume_integrals<dim>(occupancy, cell, line, volume);
        for (const BoxFace face : GeometryInfo<dim>::face_indices())
          {
            const Wall<dim> *const wall = locator.cells.wall_at(cell, face);
            if (wall == nullptr)
              continue;
            const auto area = areas.find({wall->number, face.direction()});
            if (area != areas.end())
              add_area_integrals<dim>(
                occupancy, cell, face, line, area->second);
          }
      }
    volume.compress(VectorOperation::add);
    for (auto &[wall, area] : areas)
      area.compress(VectorOperation::add);

    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        const double V = volume.local_element(node);
        for (const auto &[wall, area] : areas)
          if (V > 0. && area.local_element(node) > 0.)
            contacts.push_back({node,
                                wall.first,
                                wall.second,
                                0.5 * walls[wall.first].friction *
                                  area.local_element(node) / V});
      }
  }

  template <int dim>
  void
  WallFriction<dim>::apply(GridState<dim> &state)
  {
    state.drags.clear();
    if (!exists)
      return;
    for (auto begin = contacts.cbegin(); begin != contacts.cend();)
      {
        auto end = begin;
        while (end != contacts.cend() && end->node == begin->node)
          ++end;
        brake(state, begin, end);
        begin = end;
      }
    state.velocity_start.update_ghost_values();
  }

  template <int dim>
  void
  WallFriction<dim>::brake(GridState<dim>                               &state,
                           typename std::vector<Contact>::const_iterator begin,
                           typename std::vector<Contact>::const_iterator end)
  {
    const unsigned int node  = begin->node;
    const unsigned int fixed = occupancy.constraints.fixed_components(node);
    // an oblique normal takes the place of all that meet at its edge
    const unsigned int oblique = fixed & (1u << dim);
    const auto         holds   = [&](const Contact &contact) {
      return ((fixed >> contact.component) & 1u) || oblique ||
             occupancy.constraints.is_held_at_faces(node, contact.component);
    };
    double k = 0.;
    for (auto contact = begin; contact != end; ++contact)
      if (holds(*contact))
        k += contact->rate;
    if (k == 0.)
      return;
    Tensor<1, dim> v;
    for (unsigned int c = 0; c < dim; ++c)
      if (!((fixed >> c) & 1u))
        v[c] = state.velocity_start.local_element(dim * node + c);
    if (oblique)
      {
        const Tensor<1, dim> &n = occupancy.constraints.oblique_normal(node);
        v -= (v * n) * n;
      }
    const double way = k * v.norm() * state.dt;
    v *= -way / (1. + way);
    for (unsigned int c = 0; c < dim; ++c)
      state.velocity_start.local_element(dim * node + c) += v[c];
    const double   mass = row_mass.of_points(state, node);
    Tensor<1, dim> impulse;
    for (unsigned int c = 0; c < dim; ++c)
      impulse[c] = v[c] * (mass - state.unseen(node, c));
    for (auto contact = begin; contact != end; ++contact)
      if (holds(*contact))
        state.drags.push_back(
          {node, contact->wall, contact->rate / k / state.dt * impulse});
  }

  template class WallFriction<2>;
  template class WallFriction<3>;
} // namespace seiche
