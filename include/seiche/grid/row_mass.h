// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_row_mass_h
#define seiche_grid_row_mass_h

#include <seiche/grid/grid_state.h>
#include <seiche/space/occupancy.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Masses of the nodes at walls by their shape functions, where
   * GridState::mass has that of the hats between nodes. All are the same for
   * degree 1.
   */
  template <int dim>
  class RowMass
  {
  public:
    /// The reference must outlive the object; @p is_needed: does anything in
    /// the scene ask for value()?
    RowMass(const Occupancy<dim> &occupancy, const bool is_needed);

    /// After a change of the occupied cells. Collective.
    void
    reinit(const PointCloud<dim> &points);

    /// Of an own node's row in the weak forms, the integral of rho N [kg]:
    /// positive.
    double
    value(const GridState<dim> &state, const unsigned int node) const
    {
      return state.mass.local_element(node) *
             (factor.empty() ? 1. : factor[node]);
    }

    /// sum_p m_p N [kg] of an own node: the momentum that a wall takes from the
    /// points where it changes the node's velocity by one, m^ in doc/theory.md
    /// (8.0b).
    double
    of_points(const GridState<dim> &state, const unsigned int node) const
    {
      return masses.empty() ? state.mass.local_element(node) : masses[node];
    }

    /// The same of the points that count for a component of velocity_n.
    double
    seen(const GridState<dim> &state, const WallDirection<dim> &direction) const
    {
      const unsigned int node = direction.node;
      return of_points(state, node) -
             (direction.component < dim ?
                state.unseen(node, direction.component) :
                0.);
    }

  private:
    const Occupancy<dim> &occupancy;
    const bool            is_needed;
    std::vector<double>   factor, masses; ///< by own node; degree 1: empty
  };
} // namespace seiche

#endif
