// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/convex_edges.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    bool
    has_several(const unsigned int components)
    {
      return (components & (components - 1u)) != 0;
    }
  } // namespace

  template <int dim>
  ConvexEdges<dim>::ConvexEdges(Occupancy<dim> &grid_occupancy,
                                const bool      has_pressure)
    : occupancy(grid_occupancy)
    , exist(grid_occupancy.locator.grid.parameters.obstacles().size() > 0)
    , with_pressure(has_pressure)
  {}

  template <int dim>
  void
  ConvexEdges<dim>::reinit()
  {
    nodes.clear();
    if (!exist)
      return;
    const auto                 &locator = occupancy.locator;
    const unsigned int          n_own   = occupancy.nodes.n_own();
    std::vector<unsigned int>   wet(n_own, 0), concave(n_own, 0);
    std::vector<Tensor<1, dim>> area(n_own);
    std::vector<char>           has_fluid(n_own, 0);
    const auto                  look_at = [&](const unsigned int cell) {
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        {
          // for a hanging node: with degree 1 its master in the same corner
          const unsigned int node = occupancy.nodes.of_cell(cell)[a];
          if (node >= occupancy.nodes.n_own() ||
              occupancy.constraints.wall_components(node) == 0)
            continue;
          has_fluid[node] = 1;
          if (occupancy.fe.degree > 1 &&
              occupancy.mesh_nodes.hanging.hangs(cell, a))
            // masters lie elsewhere: all stays fixed
            wet[node] = concave[node] = ~0u;
          unsigned int of_cell = 0;
          for (const BoxFace face : GeometryInfo<dim>::face_indices())
            if (is_on_face<dim>(occupancy.fe.degree, a, face) &&
                locator.cells.wall_at(cell, face))
              {
                const unsigned int d = face.direction();
                of_cell |= 1u << d;
                area[node][d] -= face.outward() *
                                 locator.cells.geometry(cell).measure /
                                 locator.cells.geometry(cell).edges[d];
              }
          wet[node] |= of_cell;
          if (has_several(of_cell))
            concave[node] |= of_cell;
        }
    };
    // the inside of a surface along a face may reach a little beyond the edge
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      if (occupancy.cells.holds_points(cell))
        look_at(cell);
    for (unsigned int node = 0; node < n_own; ++node)
      if (has_fluid[node])
        nodes.push_back({node, wet[node], concave[node], area[node]});
  }

  template <int dim>
  unsigned int
  ConvexEdges<dim>::obstacle_components(const unsigned int node) const
  {
    unsigned int slip = 0, other = 0;
    for (const auto &[wall, component, sides, cell, is_normal] :
         occupancy.constraints.walls_at(node))
      if (!occupancy.locator.grid.wall(wall).is_side() &&
          (sides == 1u || sides == 2u) &&
          occupancy.locator.grid.wall(wall).condition != WallCondition::no_slip)
        slip |= 1u << component;
      else
        other |= 1u << component;
    return slip & ~other;
  }

  template <int dim>
  unsigned int
  ConvexEdges<dim>::slowest_inward(const unsigned int    node,
                                   const unsigned int    components,
                                   const GridState<dim> &state) const
  {
    unsigned int result = dim;
    double       least  = std::numeric_limits<double>::max();
    for (const auto &[wall, component, sides, cell, is_normal] :
         occupancy.constraints.walls_at(node))
      if ((components >> component) & 1u)
        {
          const double speed =
            (sides == 1u ? -1. : 1.) *
            state.velocity_n.local_element(dim * node + component);
          if (speed <= 0.)
            return dim;
          if (speed < least)
            {
              least  = speed;
              result = component;
            }
        }
    return result;
  }

  template <int dim>
  void
  ConvexEdges<dim>::update(const GridState<dim> &state)
  {
    if (!exist)
      return;
    for (const auto &[node, wet_components, concave, area] : nodes)
      {
        const unsigned int faces = obstacle_components(node);
        const unsigned int wet   = faces & wet_components;
        unsigned int       free  = faces & ~wet;
        if (wet == 0 && free != 0)
          {
            const unsigned int slowest = slowest_inward(node, free, state);
            if (slowest < dim)
              free &= ~(1u << slowest);
          }
        occupancy.constraints.set_dry(node, free);
        if (with_pressure && has_several(wet) && !has_several(wet & concave))
          {
            Tensor<1, dim> normal;
            for (unsigned int c = 0; c < dim; ++c)
              if ((wet >> c) & 1u)
                normal[c] = area[c];
            occupancy.constraints.set_oblique(node,
                                              wet,
                                              normal / normal.norm());
          }
      }
    occupancy.constraints.share_obliques();
  }

  template class ConvexEdges<2>;
  template class ConvexEdges<3>;
} // namespace seiche
