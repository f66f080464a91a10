// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_level_at_walls_h
#define seiche_grid_level_at_walls_h

#include <seiche/grid/fluid_below_plane.h>
#include <seiche/space/occupancy.h>

#include <vector>

namespace seiche
{
  /**
   * @brief The level set at nodes of cells that walls of solids cut, from that
   * of their neighbours (doc/theory.md, section 8): the fill says little where
   * hardly any of the node's hat is wet.
   *
   * Nodes beside known ones become known, those beside these next. Who follows
   * from whom depends on what is wet, and is found anew for each fill.
   */
  template <int dim>
  class LevelAtWalls
  {
  public:
    using Vector = typename Occupancy<dim>::Vector;

    /// @p occupancy must outlive the object.
    explicit LevelAtWalls(const Occupancy<dim> &occupancy);

    /// For walls that leave these shares of the nodes' hats, filled by @p
    /// wet_fill; own and ghost nodes. Collective.
    void
    reinit(const Vector &wet_shares, const Vector &wet_fill);

    /// Replace the level set [cells] at nodes that are mostly dry; own and
    /// ghost nodes. Collective.
    void
    extend(Vector &level) const;

  private:
    /// A vertex of an own or ghost cell.
    struct Corner
    {
      unsigned int cell, vertex;
    };

    /// A node beside another one.
    struct Neighbor
    {
      dealii::Tensor<1, dim> way; ///< to it [cells]
      Corner                 corner;
      unsigned int           node; ///< none: it hangs, or is seen through C
    };

    /// A node and those its level set follows from.
    struct Follower
    {
      unsigned int          node;
      FluidBelowPlane<dim>  fluid;
      std::vector<Corner>   corners; ///< that it is
      std::vector<Neighbor> neighbors;
    };

    /// Nodes that are mostly dry, without neighbours.
    std::vector<Follower>
    dry_nodes(const Vector &wet_shares, const Vector &wet_fill) const;

    /// What a node that is not known yet may follow from now.
    std::vector<Neighbor>
    known_neighbors(const Follower &node, const Vector &is_unknown) const;

    double
    level_of(const Neighbor &neighbor, const Vector &level) const;

    const Occupancy<dim>              &occupancy;
    std::vector<std::vector<Follower>> rounds; ///< as many on all ranks
  };
} // namespace seiche

#endif
