// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_row_mass_h
#define seiche_grid_row_mass_h

#include <seiche/grid/grid_state.h>
#include <seiche/space/occupancy.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Mass of a node's row in the weak forms, at walls: the integral of rho
   * times its shape function, where GridState::mass has that of the hat between
   * nodes. Both are the same for degree 1.
   *
   * The momentum that walls take from fluid which they stop is this mass times
   * the change of the node's velocity: m^ in doc/theory.md (8.0b).
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
    reinit();

    /// Of an own node at a wall [kg].
    double
    value(const GridState<dim> &state, const unsigned int node) const
    {
      return state.mass.local_element(node) *
             (factor.empty() ? 1. : factor[node]);
    }

  private:
    const Occupancy<dim> &occupancy;
    const bool            is_needed;
    std::vector<double>   factor; ///< by own node; degree 1: empty
  };
} // namespace seiche

#endif
