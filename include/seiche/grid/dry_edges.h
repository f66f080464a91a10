// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_dry_edges_h
#define seiche_grid_dry_edges_h

#include <seiche/grid/grid_state.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Frees the nodes on convex edges of obstacles from the faces that
   * have no fluid at them.
   *
   * A node on an edge belongs to two faces (in a corner to three). Fixed by
   * all of them it turns back the water that climbs one face or passes the
   * side of an obstacle. A component is fixed here only where an occupied cell
   * has one of the obstacle's faces normal to it. If no face at the node has
   * fluid, which is then in the cell across the edge only, the fluid may go
   * to either side but not into the edge: if all components point
   * there, the slowest one stays fixed.
   */
  template <int dim>
  class DryEdges
  {
  public:
    /// References must outlive the object.
    explicit DryEdges(Occupancy<dim> &occupancy);

    /// Choose for the occupied cells and state.velocity_n of this step.
    /// Collective.
    void
    update(const GridState<dim> &state);

  private:
    /// Faces of an own node's obstacles: bits of components.
    struct EdgeNode
    {
      unsigned int wet       = 0; ///< with fluid in a cell at them
      bool         has_fluid = false;
    };

    void
    find_fluid();

    /// Components that slip obstacles alone fix at an own node, bit by bit.
    unsigned int
    obstacle_components(const unsigned int node) const;

    /// Component that moves into the obstacle slowest, or dim if one leaves.
    unsigned int
    slowest_inward(const unsigned int    node,
                   const unsigned int    components,
                   const GridState<dim> &state) const;

    Occupancy<dim>       &occupancy;
    const bool            exist; ///< obstacles
    std::vector<EdgeNode> nodes; ///< by own node
  };
} // namespace seiche

#endif
