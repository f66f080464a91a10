// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/wall_friction.h>

#include <bitset>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Integral of the outermost shape function over a cell of unit width.
    double
    width_at_wall(const unsigned int degree)
    {
      return degree == 1 ? 1. / 2. : 1. / 6.;
    }

    /// The same of the hat with which GridState::mass is summed.
    double
    hat_width(const unsigned int degree)
    {
      return 0.5 / degree;
    }
  } // namespace

  template <int dim>
  WallFriction<dim>::WallFriction(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
    , exists(grid_occupancy.locator.grid.parameters.any_friction())
  {}

  template <int dim>
  double
  WallFriction<dim>::rate(const unsigned int node) const
  {
    const auto &locator = occupancy.locator;
    double      k       = 0.;
    for (const auto &entry : occupancy.walls_at(node))
      if ((occupancy.fixed_components(node) >> entry.component) & 1u)
        k += 0.5 * locator.grid.parameters.friction(entry.wall) /
             (width_at_wall(occupancy.fe.degree) *
              locator.extent(entry.cell)[entry.component]);
    return k;
  }

  template <int dim>
  void
  WallFriction<dim>::apply(GridState<dim> &state)
  {
    drags.clear();
    if (!exists)
      return;
    const unsigned int degree = occupancy.fe.degree;
    for (unsigned int node = 0; node < occupancy.n_own_nodes(); ++node)
      {
        const unsigned int fixed = occupancy.fixed_components(node);
        const double       k     = fixed != 0 ? rate(node) : 0.;
        if (k == 0.)
          continue;
        Tensor<1, dim> v;
        for (unsigned int c = 0; c < dim; ++c)
          if (!((fixed >> c) & 1u))
            v[c] = state.velocity_start.local_element(dim * node + c);
        const double way = k * v.norm() * state.dt;
        v *= -way / (1. + way);
        for (unsigned int c = 0; c < dim; ++c)
          state.velocity_start.local_element(dim * node + c) += v[c];
        const double mass = state.mass.local_element(node) *
                            std::pow(width_at_wall(degree) / hat_width(degree),
                                     std::bitset<dim>(fixed).count());
        drags.emplace_back(node, mass / state.dt * v);
      }
    state.velocity_start.update_ghost_values();
  }

  template <int dim>
  void
  WallFriction<dim>::add_reactions(GridState<dim> &state) const
  {
    for (const auto &[node, drag] : drags)
      for (unsigned int c = 0; c < dim; ++c)
        state.reaction.local_element(dim * node + c) += drag[c];
  }

  template class WallFriction<2>;
  template class WallFriction<3>;
} // namespace seiche
