// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_convex_edges_h
#define seiche_grid_convex_edges_h

#include <seiche/grid/grid_state.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Lets the fluid slip around the convex edges of obstacles
   * (doc/theory.md, section 8, convex edges).
   *
   * A node on an edge belongs to two faces (in a corner to three). Fixed by
   * all of them it turns back the water that climbs one face, passes the side
   * of an obstacle or turns round the edge. With several wet faces its
   * component normal to a face is zero in the cells at that face alone (8.0c).
   * A face without a cell with points at the node does not fix it. If none has
   * one, the fluid is in the cell across the edge only and may go to either
   * side but not into the edge: if all components point there, the slowest one
   * stays fixed.
   */
  template <int dim>
  class ConvexEdges
  {
  public:
    /// @p occupancy must outlive the object.
    explicit ConvexEdges(Occupancy<dim> &occupancy);

    /// After a change of the occupied cells: find the faces with fluid at them
    /// and what is zero in the cells there. Collective.
    void
    reinit();

    /// Free components; choose for state.velocity_n. Collective.
    void
    update(const GridState<dim> &state);

  private:
    /// Own node on a wall, with a vertex of a cell with points at it.
    /// Components bit by bit.
    struct WallNode
    {
      unsigned int node;
      unsigned int faces;   ///< normal to faces of slip obstacles alone
      unsigned int wet;     ///< of these: a cell with points has such a face
      bool         is_edge; ///< several, each with cells of its own
    };

    /// Components that slip obstacles alone fix at an own node.
    unsigned int
    obstacle_components(const unsigned int node) const;

    using Vector = typename GridState<dim>::Vector;

    /// Collective.
    void
    find_nodes();

    /// Components of @p faces_of_node to which a cell has a face of a wall at
    /// its node @p a.
    unsigned int
    faces_of_cell(const unsigned int cell,
                  const unsigned int a,
                  const unsigned int faces_of_node) const;

    /// Bits of own nodes, and those of ghost nodes from their owners.
    /// Collective.
    std::vector<unsigned int>
    share_bits(const std::vector<unsigned int> &of_own) const;

    /// Zero components of the cells at edges. Collective.
    void
    set_zeros();
    template <int degree>
    void
    set_zeros_in(const unsigned int               cell,
                 const std::vector<unsigned int> &edge_components);

    /// Component that moves into the obstacle slowest, or dim if one leaves.
    unsigned int
    slowest_inward(const unsigned int    node,
                   const unsigned int    components,
                   const GridState<dim> &state) const;

    Occupancy<dim>       &occupancy;
    const bool            exist; ///< obstacles
    std::vector<WallNode> nodes;
  };
} // namespace seiche

#endif
