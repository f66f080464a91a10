// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_convex_edges_h
#define seiche_grid_convex_edges_h

#include <seiche/grid/grid_state.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Frees the nodes on convex edges of obstacles from the faces that
   * have no fluid at them (doc/theory.md, section 8, convex edges).
   *
   * A node on an edge belongs to two faces (in a corner to three). Fixed by
   * all of them it turns back the water that climbs one face or passes the
   * side of an obstacle. A component is fixed here only where an occupied cell
   * has one of the obstacle's faces normal to it. If no face at the node has
   * fluid, which is then in the cell across the edge only, the fluid may go
   * to either side but not into the edge: if all components point
   * there, the slowest one stays fixed. With several wet faces the node is
   * fixed along their mean normal instead (8.0c), if the formulation has a
   * pressure.
   */
  template <int dim>
  class ConvexEdges
  {
  public:
    /// References must outlive the object. @p with_pressure: of formulation.
    ConvexEdges(Occupancy<dim> &occupancy, const bool with_pressure);

    /// After a change of the occupied cells: find the faces with fluid at them.
    void
    reinit();

    /// Choose for state.velocity_n. Collective.
    void
    update(const GridState<dim> &state);

  private:
    /// Own node on a wall, with a vertex of an occupied cell at it.
    struct WallNode
    {
      unsigned int node;
      unsigned int wet; ///< bit c: an occupied cell has a face normal to c here
      unsigned int concave;        ///< the same, of cells with more than one
      dealii::Tensor<1, dim> area; ///< wet, in proportion; into the fluid [m^2]
    };

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
    const bool            with_pressure;
    std::vector<WallNode> nodes;
  };
} // namespace seiche

#endif
