// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_friction.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <map>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Integrals of the shape functions of a line of unit length.
    std::vector<double>
    line_integrals(const unsigned int degree)
    {
      return degree == 1 ? std::vector<double>{1. / 2., 1. / 2.} :
                           std::vector<double>{1. / 6., 4. / 6., 1. / 6.};
    }

    /// The same of the hats between the nodes.
    std::vector<double>
    hat_integrals(const unsigned int degree)
    {
      return degree == 1 ? std::vector<double>{1. / 2., 1. / 2.} :
                           std::vector<double>{1. / 4., 1. / 2., 1. / 4.};
    }

    /**
     * Add a cell's integrals over its volume, or over one of its faces, to the
     * nodes that are unknowns.
     */
    template <int dim>
    void
    add_integrals(const Occupancy<dim>            &occupancy,
                  const unsigned int               cell,
                  const std::vector<double>       &line,
                  const unsigned int               face,
                  typename Occupancy<dim>::Vector &result)
    {
      constexpr unsigned int all    = numbers::invalid_unsigned_int;
      const Tensor<1, dim>   extent = occupancy.locator.extent(cell);
      double                 integrals[HangingNodes<dim>::max_nodes];
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        {
          integrals[a] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int place = occupancy.place(a, d);
              if (face == all || d != face / 2)
                integrals[a] *= extent[d] * line[place];
              else if (place != (face % 2) * occupancy.fe.degree)
                integrals[a] = 0.;
            }
        }
      occupancy.condense(cell, integrals);
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        result.local_element(occupancy.cell_nodes(cell)[a]) += integrals[a];
    }
  } // namespace

  template <int dim>
  WallFriction<dim>::WallFriction(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
    , exists(grid_occupancy.locator.grid.parameters.any_friction())
  {}

  template <int dim>
  void
  WallFriction<dim>::reinit()
  {
    contacts.clear();
    mass_factor.clear();
    if (!exists)
      return;
    const auto                &locator = occupancy.locator;
    const GridParameters<dim> &walls   = locator.grid.parameters;
    const unsigned int         degree  = occupancy.fe.degree;
    const auto                 line    = line_integrals(degree);
    const Vector               zero(occupancy.scalar_partitioner());

    Vector volume(zero), hat_volume(zero);
    // the same walls on every rank
    std::map<std::pair<unsigned int, unsigned int>, Vector> areas;
    for (unsigned int wall = 0; wall < walls.n_walls(); ++wall)
      for (unsigned int d = 0; d < dim; ++d)
        if (walls.friction(wall) > 0. && (wall >= 2 * dim || wall / 2 == d))
          areas.emplace(std::make_pair(wall, d), zero);
    const auto touches_wall = [&](const unsigned int cell) {
      const unsigned int *nodes = occupancy.cell_nodes(cell);
      return std::any_of(nodes,
                         nodes + occupancy.nodes_per_cell(),
                         [&](const unsigned int node) {
                           return occupancy.wall_components(node) != 0;
                         });
    };
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        if (!touches_wall(cell))
          continue;
        add_integrals<dim>(
          occupancy, cell, line, numbers::invalid_unsigned_int, volume);
        if (degree > 1)
          add_integrals<dim>(occupancy,
                             cell,
                             hat_integrals(degree),
                             numbers::invalid_unsigned_int,
                             hat_volume);
        for (const unsigned int face : GeometryInfo<dim>::face_indices())
          {
            const auto area =
              areas.find({locator.boundary_id(cell, face), face / 2});
            if (area != areas.end())
              add_integrals<dim>(occupancy, cell, line, face, area->second);
          }
      }
    volume.compress(VectorOperation::add);
    hat_volume.compress(VectorOperation::add);
    for (auto &[wall, area] : areas)
      area.compress(VectorOperation::add);

    for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
      {
        const double V = volume.local_element(node);
        if (degree > 1)
          mass_factor.push_back(V > 0. ? V / hat_volume.local_element(node) :
                                         0.);
        for (const auto &[wall, area] : areas)
          if (V > 0. && area.local_element(node) > 0.)
            contacts.push_back({node,
                                wall.first,
                                wall.second,
                                0.5 * walls.friction(wall.first) *
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
    const unsigned int fixed = occupancy.fixed_components(node);
    const auto         holds = [&](const Contact &contact) {
      return (fixed >> contact.component) & 1u;
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
    const double way = k * v.norm() * state.dt;
    v *= -way / (1. + way);
    for (unsigned int c = 0; c < dim; ++c)
      state.velocity_start.local_element(dim * node + c) += v[c];
    const double mass = state.mass.local_element(node) *
                        (mass_factor.empty() ? 1. : mass_factor[node]);
    for (auto contact = begin; contact != end; ++contact)
      if (holds(*contact))
        state.drags.push_back(
          {node, contact->wall, contact->rate / k * mass / state.dt * v});
  }

  template class WallFriction<2>;
  template class WallFriction<3>;
} // namespace seiche
