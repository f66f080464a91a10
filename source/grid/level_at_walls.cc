// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/level_at_walls.h>
#include <seiche/grid/level_nearby.h>
#include <seiche/space/cut_cell.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of a node whose level set is not its own: less of its hat is wet.
    constexpr double mostly_dry = 0.5;
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
            {i,
             FluidBelowPlane<dim>(wet_fill.local_element(i) * nodes.volume(i)),
             {},
             {}});
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
    const CutWalls<dim> &walls = occupancy.mesh_nodes.cut_walls;
    VertexValues<dim>    nowhere;
    nowhere.fill(1.);
    for (Follower &node : result)
      for (const auto &[cell, vertex] : node.corners)
        if (walls.wet_share(cell) > 0.)
          node.fluid.add_cell(vertex,
                              occupancy.locator.cells.geometry(cell).measure,
                              walls.hat_integrals(cell)[vertex],
                              walls.cuts(cell) ? walls.distance(cell) :
                                                 nowhere);
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
        for (Follower &node : waiting)
          node.neighbors = known_neighbors(node, unknown);
        const auto found =
          std::stable_partition(waiting.begin(),
                                waiting.end(),
                                [](const Follower &node) {
                                  return node.neighbors.empty();
                                });
        any_found = Utilities::MPI::sum(waiting.end() - found,
                                        wet_shares.get_mpi_communicator()) > 0;
        if (any_found)
          rounds.emplace_back(std::make_move_iterator(found),
                              std::make_move_iterator(waiting.end()));
        waiting.erase(found, waiting.end());
        if (any_found)
          for (const Follower &follower : rounds.back())
            unknown.local_element(follower.node) = 0.;
        unknown.update_ghost_values();
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
                return follower.fluid.level(gradient,
                                            most,
                                            level.local_element(follower.node));
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
