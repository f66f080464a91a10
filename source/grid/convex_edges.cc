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
  ConvexEdges<dim>::ConvexEdges(Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
    , exist(grid_occupancy.locator.grid.parameters.obstacles().size() > 0)
  {}

  template <int dim>
  void
  ConvexEdges<dim>::reinit()
  {
    if (!exist)
      return;
    find_nodes();
    set_zeros();
  }

  template <int dim>
  std::vector<unsigned int>
  ConvexEdges<dim>::share_bits(const std::vector<unsigned int> &of_own) const
  {
    Vector bits(occupancy.nodes.partitioner());
    for (unsigned int node = 0; node < of_own.size(); ++node)
      bits.local_element(node) = of_own[node];
    bits.update_ghost_values();
    std::vector<unsigned int> result(occupancy.nodes.n_local());
    for (unsigned int node = 0; node < result.size(); ++node)
      result[node] = static_cast<unsigned int>(bits.local_element(node));
    return result;
  }

  template <int dim>
  void
  ConvexEdges<dim>::find_nodes()
  {
    nodes.clear();
    const unsigned int        n_own = occupancy.nodes.n_own();
    std::vector<unsigned int> of_own(n_own, 0);
    for (unsigned int node = 0; node < n_own; ++node)
      if (occupancy.constraints.wall_components(node) != 0)
        of_own[node] = obstacle_components(node);
    const std::vector<unsigned int> faces = share_bits(of_own);

    // of own cells, added: an owner may not see a cell with a hanging node
    // whose master is its own
    Vector wet(occupancy.nodes.vector_partitioner()),
      has_fluid(occupancy.nodes.partitioner()), concave(has_fluid);
    // the inside of a surface along a face may reach a little beyond the edge
    for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
         ++cell)
      if (occupancy.cells.holds_points(cell))
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          {
            // for a hanging node: with degree 1 its master in the same corner
            const unsigned int node       = occupancy.nodes.of_cell(cell)[a];
            const unsigned int of_cell    = faces_of_cell(cell, a, faces[node]);
            has_fluid.local_element(node) = 1.;
            for (unsigned int c = 0; c < dim; ++c)
              if ((of_cell >> c) & 1u)
                wet.local_element(dim * node + c) = 1.;
            if (has_several(of_cell))
              concave.local_element(node) = 1.;
          }
    for (Vector *marks : {&wet, &has_fluid, &concave})
      marks->compress(VectorOperation::add);
    for (unsigned int node = 0; node < n_own; ++node)
      if (has_fluid.local_element(node) > 0. &&
          occupancy.constraints.wall_components(node) != 0)
        {
          unsigned int components = 0;
          for (unsigned int c = 0; c < dim; ++c)
            if (wet.local_element(dim * node + c) > 0.)
              components |= 1u << c;
          nodes.push_back(
            {node,
             faces[node],
             components,
             has_several(components) && concave.local_element(node) == 0.});
        }
  }

  template <int dim>
  unsigned int
  ConvexEdges<dim>::faces_of_cell(const unsigned int cell,
                                  const unsigned int a,
                                  const unsigned int faces_of_node) const
  {
    if (faces_of_node == 0)
      return 0;
    if (occupancy.fe.degree > 1 && occupancy.mesh_nodes.hanging.hangs(cell, a))
      return faces_of_node; // masters lie elsewhere: all stays fixed
    unsigned int result = 0;
    for (const BoxFace face : GeometryInfo<dim>::face_indices())
      if (is_on_face<dim>(occupancy.fe.degree, a, face) &&
          occupancy.locator.cells.wall_at(cell, face))
        result |= 1u << face.direction();
    return result & faces_of_node;
  }

  template <int dim>
  void
  ConvexEdges<dim>::set_zeros()
  {
    std::vector<unsigned int> of_own(occupancy.nodes.n_own(), 0);
    for (const WallNode &here : nodes)
      if (here.is_edge)
        of_own[here.node] = here.wet;
    const std::vector<unsigned int> components = share_bits(of_own);
    occupancy.for_each_degree([&](const auto degree) {
      for (unsigned int cell = 0; cell < occupancy.locator.cells.size(); ++cell)
        if (occupancy.cells.is_occupied(cell))
          this->template set_zeros_in<degree>(cell, components);
    });
    occupancy.zero_components.share(
      occupancy.nodes.partitioner()->get_mpi_communicator());
  }

  template <int dim>
  template <int degree>
  void
  ConvexEdges<dim>::set_zeros_in(
    const unsigned int               cell,
    const std::vector<unsigned int> &edge_components)
  {
    const auto   unknowns = occupancy.template unknowns<degree>(cell);
    unsigned int of_cell  = 0;
    for (unsigned int a = 0; a < unknowns.n_nodes; ++a)
      of_cell |= edge_components[unknowns[a]];
    if (of_cell == 0)
      return;
    for (const BoxFace face : GeometryInfo<dim>::face_indices())
      {
        const unsigned int     d = face.direction();
        const Wall<dim> *const wall =
          occupancy.locator.cells.wall_at(cell, face);
        if (wall == nullptr || wall->is_side() || !((of_cell >> d) & 1u))
          continue;
        for (unsigned int a = 0; a < unknowns.n_nodes; ++a)
          // masters on an edge must not move a hanging node into the face
          if (is_on_face<dim>(degree, a, face) &&
              (((edge_components[unknowns[a]] >> d) & 1u) ||
               (unknowns.matrix != nullptr && !unknowns.matrix->is_free(a))))
            occupancy.zero_components.add(
              cell, occupancy.locator.cells.size(), degree, d, a);
      }
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
    for (const auto &[node, faces, wet, is_edge] : nodes)
      {
        unsigned int free = is_edge ? faces : faces & ~wet;
        if (wet == 0 && free != 0)
          {
            const unsigned int slowest = slowest_inward(node, free, state);
            if (slowest < dim)
              free &= ~(1u << slowest);
          }
        occupancy.constraints.set_free(node, free, is_edge ? wet : 0u);
      }
    occupancy.constraints.share();
  }

  template class ConvexEdges<2>;
  template class ConvexEdges<3>;
} // namespace seiche
