// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/surface.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

// The part of Surface that finds the level set at nodes of cells that walls of
// solids cut (doc/theory.md, section 8): the fill says little there, for hardly
// any of the node's hat may be wet.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Level sets end there; what is fitted may be beyond. Near the end they
    /// say nothing: fills of disordered points are off by 2 %.
    constexpr double end       = 1.;
    constexpr double near_end  = 0.8;
    constexpr double round_off = 1e-9;

    /// Rounds in which nodes beside known ones become known, the wettest first.
    constexpr unsigned int n_rounds = 8;

    /// Of a node whose level set is not its own: less of its hat is wet.
    constexpr double mostly_dry = 0.5;

    /// Rounds of fill and level set.
    constexpr unsigned int n_continuations = 4;

    /// A node about another one.
    template <int dim>
    struct Neighbor
    {
      Tensor<1, dim> way; ///< to it [cells]
      double         level;
    };

    /// A linear function.
    template <int dim>
    struct Plane
    {
      double         mean = 0.;
      Tensor<1, dim> centre, slope;

      double
      value(const Tensor<1, dim> &way) const
      {
        return mean + slope * (way - centre);
      }
    };

    /// That which is nearest to those neighbours that count, at least one:
    /// constant in directions in which they do not differ.
    template <int dim>
    Plane<dim>
    fit(const std::vector<Neighbor<dim>> &neighbors,
        const std::vector<char>          &counts)
    {
      constexpr double apart = 1e-3; // mean square of ways that do differ
      Plane<dim>       result;
      double           n = 0.;
      for (unsigned int i = 0; i < neighbors.size(); ++i)
        if (counts[i])
          {
            n += 1.;
            result.mean += neighbors[i].level;
            result.centre += neighbors[i].way;
          }
      result.mean /= n;
      result.centre /= n;
      SymmetricTensor<2, dim> square;
      Tensor<1, dim>          product;
      for (unsigned int i = 0; i < neighbors.size(); ++i)
        if (counts[i])
          {
            const Tensor<1, dim> way = neighbors[i].way - result.centre;
            square += symmetrize(outer_product(way, way));
            product += (neighbors[i].level - result.mean) * way;
          }
      for (const auto &[value, direction] : eigenvectors(square))
        if (value > apart * n)
          result.slope += (direction * product) / value * direction;
      return result;
    }

    /// Value at the origin of the plane through the neighbours; one near the
    /// end of the level set says that it is there or beyond: there (5.0b) has
    /// an infinite slope. The level set is a distance: its slope is one.
    template <int dim>
    double
    level_from(std::vector<Neighbor<dim>> neighbors)
    {
      constexpr unsigned int most_rounds  = 10;
      constexpr double       least_slope  = 0.1; // less: there is none
      constexpr double       likely_slope = 0.5; // less: hardly a distance
      std::vector<char>      counts(neighbors.size());
      for (unsigned int i = 0; i < neighbors.size(); ++i)
        counts[i] = std::abs(neighbors[i].level) < near_end;
      const Plane<dim> all =
        fit(neighbors, std::vector<char>(neighbors.size(), 1));
      if (std::count(counts.begin(), counts.end(), 1) == 0)
        return all.value(Tensor<1, dim>());
      const std::vector<char> is_known = counts;
      Plane<dim>              result;
      for (unsigned int round = 0; round < most_rounds; ++round)
        {
          result = fit(neighbors, counts);
          if (result.slope.norm() < likely_slope)
            result.slope = all.slope;
          if (const double slope = result.slope.norm(); slope > least_slope)
            result.slope /= slope;
          const std::vector<char> before = counts;
          for (unsigned int i = 0; i < neighbors.size(); ++i)
            if (!is_known[i])
              {
                const double level = neighbors[i].level;
                const double least = std::copysign(near_end, level);
                counts[i] =
                  (least - result.value(neighbors[i].way)) * level > round_off;
              }
          if (counts == before)
            break;
        }
      return result.value(Tensor<1, dim>());
    }
  } // namespace

  template <int dim>
  void
  Surface<dim>::find_wall_nodes()
  {
    wall_nodes.clear();
    const auto               &nodes = occupancy.nodes;
    std::vector<unsigned int> place(nodes.n_own(),
                                    numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < nodes.n_own(); ++i)
      if (wet_share(i) < mostly_dry)
        {
          place[i] = wall_nodes.size();
          wall_nodes.push_back({i, {}});
        }
    for (unsigned int cell = 0; cell < occupancy.locator.cells.size(); ++cell)
      if (occupancy.cells.is_active(cell))
        for (unsigned int v = 0; v < CutCell<dim>::n_vertices; ++v)
          {
            const unsigned int a    = vertex_node<dim>(occupancy.fe.degree, v);
            const unsigned int node = nodes.of_cell(cell)[a];
            if (node < nodes.n_own() &&
                place[node] != numbers::invalid_unsigned_int &&
                !occupancy.mesh_nodes.hanging.hangs(cell, a))
              wall_nodes[place[node]].corners.push_back({cell, v});
          }
  }

  template <int dim>
  void
  Surface<dim>::extend_into_solids()
  {
    if (!walls().exist())
      return;
    Vector wet(level), unknown(level);
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      {
        wet.local_element(i)     = wet_share(i);
        unknown.local_element(i) = wet_share(i) < mostly_dry;
      }
    wet.update_ghost_values();
    unknown.update_ghost_values();
    for (unsigned int round = 0; round < n_rounds; ++round)
      {
        std::vector<std::pair<unsigned int, double>> found;
        for (const WallNode &node : wall_nodes)
          {
            if (unknown.local_element(node.node) == 0.)
              continue;
            const double               own   = wet.local_element(node.node);
            bool                       waits = false;
            std::vector<Neighbor<dim>> neighbors;
            for (const auto &[cell, here] : node.corners)
              {
                const VertexValues<dim> phi = rounded<dim>(level_in(cell));
                VertexValues<dim>       share, is_unknown;
                occupancy.vertex_values(cell, wet, share.data());
                occupancy.vertex_values(cell, unknown, is_unknown.data());
                for (unsigned int v = 0; v < phi.size(); ++v)
                  if (is_unknown[v] == 0.)
                    neighbors.push_back(
                      {GeometryInfo<dim>::unit_cell_vertex(v) -
                         GeometryInfo<dim>::unit_cell_vertex(here),
                       phi[v]});
                  else
                    waits = waits || share[v] > own + round_off;
              }
            if (!waits && !neighbors.empty())
              found.emplace_back(node.node, level_from(neighbors));
          }
        for (const auto &[node, value] : found)
          {
            level.local_element(node) = level_at(std::clamp(value, -end, end));
            unknown.local_element(node) = 0.;
          }
        level.update_ghost_values();
        unknown.update_ghost_values();
      }
  }

  template <int dim>
  typename Surface<dim>::Vector
  Surface<dim>::continued_fill(const Vector &wet_fill)
  {
    find_wall_nodes();
    Vector result(wet_fill);
    for (unsigned int round = 0; round < n_continuations; ++round)
      {
        set_level(result);
        Vector dry(level);
        dry = 0.;
        for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
             ++cell)
          if (occupancy.cells.is_active(cell) && walls().wet_share(cell) < 1.)
            {
              VertexValues<dim> hats =
                walls().hats_in_solids(cell, rounded<dim>(level_in(cell)));
              for (double &value : hats)
                value *= occupancy.locator.cells.geometry(cell).measure;
              occupancy.add_vertex_values(cell, hats.data(), dry);
            }
        dry.compress(VectorOperation::add);
        for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
          if (const double whole = whole_volume(i); whole > 0.)
            result.local_element(i) = wet_share(i) * wet_fill.local_element(i) +
                                      dry.local_element(i) / whole;
      }
    return result;
  }

#define INSTANTIATE(dim)                                                     \
  template void                          Surface<dim>::find_wall_nodes();    \
  template void                          Surface<dim>::extend_into_solids(); \
  template typename Surface<dim>::Vector Surface<dim>::continued_fill(       \
    const Vector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
