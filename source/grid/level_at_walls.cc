// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/level_at_walls.h>
#include <seiche/grid/level_nearby.h>
#include <seiche/space/cut_cell.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of a node whose level set is not its own: less of its hat is wet.
    constexpr double mostly_dry = 0.5;

    /// Wet share of a hat that tells nothing: the slope does.
    constexpr double negligible = 1e-4;

    /// Of levels [cells] and of fluid below them.
    constexpr double tolerance = 1e-6;
  } // namespace

  template <int dim>
  LevelAtWalls<dim>::LevelAtWalls(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
  {}

  template <int dim>
  std::vector<typename LevelAtWalls<dim>::Follower>
  LevelAtWalls<dim>::dry_nodes(const Vector &wet_shares,
                               const Vector &wet_fill) const
  {
    const auto               &nodes = occupancy.nodes;
    std::vector<Follower>     result;
    std::vector<unsigned int> place(nodes.n_own(),
                                    numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < nodes.n_own(); ++i)
      if (wet_shares.local_element(i) < mostly_dry)
        {
          place[i] = result.size();
          result.push_back(
            {i, wet_fill.local_element(i) * nodes.volume(i), {}, {}});
        }
    for (unsigned int cell = 0; cell < occupancy.locator.cells.size(); ++cell)
      if (occupancy.cells.is_active(cell))
        for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
          {
            const unsigned int a    = vertex_node<dim>(occupancy.fe.degree, v);
            const unsigned int node = nodes.of_cell(cell)[a];
            if (node < nodes.n_own() &&
                place[node] != numbers::invalid_unsigned_int &&
                !occupancy.mesh_nodes.hanging.hangs(cell, a))
              result[place[node]].corners.push_back({cell, v});
          }
    return result;
  }

  template <int dim>
  std::vector<typename LevelAtWalls<dim>::Neighbor>
  LevelAtWalls<dim>::known_neighbors(const Follower &node,
                                     const Vector   &is_unknown) const
  {
    using Shape = GeometryInfo<dim>;
    std::vector<Neighbor> result;
    for (const Corner &here : node.corners)
      {
        VertexValues<dim> unknown;
        occupancy.vertex_values(here.cell, is_unknown, unknown.data());
        const bool sees_nodes =
          occupancy.mesh_nodes.hanging.matrix(here.cell) == nullptr;
        for (const unsigned int v : Shape::vertex_indices())
          if (unknown[v] == 0.)
            result.push_back(
              {Shape::unit_cell_vertex(v) -
                 Shape::unit_cell_vertex(here.vertex),
               {here.cell, v},
               sees_nodes ?
                 occupancy.nodes.of_cell(
                   here.cell)[vertex_node<dim>(occupancy.fe.degree, v)] :
                 numbers::invalid_unsigned_int});
      }
    return result;
  }

  template <int dim>
  void
  LevelAtWalls<dim>::reinit(const Vector &wet_shares, const Vector &wet_fill)
  {
    Vector unknown(wet_shares);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      unknown.local_element(i) = wet_shares.local_element(i) < mostly_dry;
    unknown.update_ghost_values();
    rounds.clear();
    std::vector<Follower> waiting   = dry_nodes(wet_shares, wet_fill);
    bool                  any_found = true;
    while (any_found)
      {
        std::vector<Follower> found;
        for (const Follower &node : waiting)
          if (auto neighbors = known_neighbors(node, unknown);
              !neighbors.empty())
            {
              found.push_back(node);
              found.back().neighbors = std::move(neighbors);
            }
        any_found = Utilities::MPI::sum(found.size(),
                                        wet_shares.get_mpi_communicator()) > 0;
        for (const Follower &follower : found)
          unknown.local_element(follower.node) = 0.;
        unknown.update_ghost_values();
        waiting.erase(std::remove_if(waiting.begin(),
                                     waiting.end(),
                                     [&](const Follower &node) {
                                       return unknown.local_element(
                                                node.node) == 0.;
                                     }),
                      waiting.end());
        rounds.push_back(std::move(found));
      }
  }

  template <int dim>
  double
  LevelAtWalls<dim>::level_of(const Neighbor &neighbor,
                              const Vector   &level) const
  {
    if (neighbor.node != numbers::invalid_unsigned_int)
      return level.local_element(neighbor.node);
    VertexValues<dim> values;
    occupancy.vertex_values(neighbor.corner.cell, level, values.data());
    return values[neighbor.corner.vertex];
  }

  template <int dim>
  double
  LevelAtWalls<dim>::level_below_plane(const Follower       &follower,
                                       const Tensor<1, dim> &gradient,
                                       const double          most) const
  {
    using Shape = GeometryInfo<dim>;
    struct Part
    {
      VertexValues<dim> plane; // through the node
      VertexValues<dim> wall;
      double            whole; // integral of the node's hat
      Corner            corner;
    };
    const CutWalls<dim> &walls = occupancy.mesh_nodes.cut_walls;
    std::vector<Part>    parts;
    double               hat = 0., cells = 0.; // integrals [m^dim]
    for (const Corner &here : follower.corners)
      if (walls.wet_share(here.cell) > 0.)
        {
          Part part{{}, {}, walls.hat_integrals(here.cell)[here.vertex], here};
          part.wall.fill(1.);
          if (walls.cuts(here.cell))
            part.wall = walls.distance(here.cell);
          for (const unsigned int v : Shape::vertex_indices())
            part.plane[v] = gradient * (Shape::unit_cell_vertex(v) -
                                        Shape::unit_cell_vertex(here.vertex));
          parts.push_back(part);
          const double measure =
            occupancy.locator.cells.geometry(here.cell).measure;
          cells += measure;
          hat += part.whole * measure;
        }
    const auto excess = [&](const double level) {
      double result = -follower.fluid;
      for (const auto &[plane, wall, whole, corner] : parts)
        {
          VertexValues<dim> phi = plane;
          for (double &value : phi)
            value += level;
          const auto [lowest, highest] =
            std::minmax_element(phi.begin(), phi.end());
          if (*lowest < 0.)
            result +=
              occupancy.locator.cells.geometry(corner.cell).measure *
              (*highest < 0. ? whole :
                               hat_integrals<dim>(phi, wall)[corner.vertex]);
        }
      return std::abs(result) < tolerance * hat ? 0. : result;
    };
    const auto is_close = [](const double lower, const double upper) {
      return upper - lower < tolerance;
    };
    double upper = most, lower = std::max(-1., most - 1.);
    if (hat < negligible * cells)
      return lower;
    const double at_upper = excess(upper);
    if (at_upper >= 0.)
      return most;
    double at_lower = excess(lower);
    if (at_lower < 0. && lower > -1.)
      {
        lower    = -1.;
        at_lower = excess(lower);
      }
    if (at_lower <= 0.)
      return lower;
    std::uintmax_t trials  = 30;
    std::tie(lower, upper) = boost::math::tools::toms748_solve(
      excess, lower, upper, at_lower, at_upper, is_close, trials);
    return 0.5 * (lower + upper);
  }

  template <int dim>
  void
  LevelAtWalls<dim>::extend(Vector &level) const
  {
    std::vector<LevelNearby<dim>> nearby;
    for (const std::vector<Follower> &round : rounds)
      {
        std::vector<double> values;
        for (const Follower &follower : round)
          {
            nearby.clear();
            for (const Neighbor &neighbor : follower.neighbors)
              nearby.push_back(
                {neighbor.way, rounded(level_of(neighbor, level))});
            values.push_back(level_from<dim>(
              nearby, [&](const Tensor<1, dim> &gradient, const double most) {
                return level_below_plane(follower, gradient, most);
              }));
          }
        for (unsigned int i = 0; i < round.size(); ++i)
          level.local_element(round[i].node) =
            nonzero_level(std::clamp(values[i], -1., 1.));
        level.update_ghost_values();
      }
  }

  template class LevelAtWalls<2>;
  template class LevelAtWalls<3>;
} // namespace seiche
