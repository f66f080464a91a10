// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_wall_friction_h
#define seiche_grid_wall_friction_h

#include <seiche/grid/grid_state.h>

#include <utility>
#include <vector>

namespace seiche
{
  /**
   * @brief Drag of boundary layers that the grid does not resolve, on walls
   * along which the fluid slips: c_f/2 rho |v| v per area (entries "Walls/...
   * friction", "Obstacle NAME/Friction"; Schlichting 1979, chapter 21).
   *
   * Split from the step, at its start, and exact there: dv/dt = -k |v| v with
   * k = c_f A/(2 V), A/V of the shape function at the wall. Stable for any dt,
   * of first order in it. A wall that has let go of a node does not brake it.
   */
  template <int dim>
  class WallFriction
  {
  public:
    /// The reference must outlive the object.
    WallFriction(const Occupancy<dim> &occupancy);

    /// Brake velocity_start, which satisfies the walls, over state.dt.
    /// Collective.
    void
    apply(GridState<dim> &state);

    /// Add the drag of the last apply() [N] to state.reaction. Local.
    void
    add_reactions(GridState<dim> &state) const;

  private:
    /// k [1/m] of the walls that hold an own node.
    double
    rate(const unsigned int node) const;

    const Occupancy<dim> &occupancy;
    const bool            exists;
    /// Own nodes and the force on them in the last apply() [N].
    std::vector<std::pair<unsigned int, dealii::Tensor<1, dim>>> drags;
  };
} // namespace seiche

#endif
