// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_wall_friction_h
#define seiche_grid_wall_friction_h

#include <seiche/grid/row_mass.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Drag of boundary layers that the grid does not resolve, on walls
   * along which the fluid slips: c_f/2 rho |v| v per area (entries "Walls/...
   * friction", "Obstacle NAME/Friction"; Schlichting 1979, chapter 21;
   * doc/theory.md (8.1), (8.2)).
   *
   * Split from the step, at its start, and exact there: dv/dt = -k |v| v with
   * k = c_f A/(2 V), A the integral of a node's shape function over the faces
   * that occupied cells have at the wall, V that over these cells. Stable for
   * any dt, of first order in it. A wall that has let go of a node does not
   * brake it.
   */
  template <int dim>
  class WallFriction
  {
  public:
    /// The references must outlive the object.
    WallFriction(const Occupancy<dim> &occupancy, const RowMass<dim> &row_mass);

    /// After a change of the occupied cells: find their faces at rough walls.
    /// Collective.
    void
    reinit();

    /// Brake velocity_start, which satisfies the walls, over state.dt; sets
    /// state.drags. Collective.
    void
    apply(GridState<dim> &state);

  private:
    using Vector = typename GridState<dim>::Vector;

    /// An own node at faces of a rough wall that are normal to a direction.
    struct Contact
    {
      unsigned int node, wall, component;
      double       rate; ///< k [1/m]
    };

    /// Brake one own node, held by contacts [begin, end).
    void
    brake(GridState<dim>                               &state,
          typename std::vector<Contact>::const_iterator begin,
          typename std::vector<Contact>::const_iterator end);

    const Occupancy<dim> &occupancy;
    const bool            exists;
    const RowMass<dim>   &row_mass;
    std::vector<Contact>  contacts; ///< by node
  };
} // namespace seiche

#endif
