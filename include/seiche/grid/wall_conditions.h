// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_wall_conditions_h
#define seiche_grid_wall_conditions_h

#include <seiche/grid/time_scheme.h>

namespace seiche
{
  /**
   * @brief Prescribes the components of velocity and displacement that walls
   * fix: zero, the velocity of a no-slip wall that moves along itself, or the
   * way of a side that moves along its normal (doc/theory.md (8.0a), (8.4)).
   *
   * Where walls meet, a side of the domain decides about its normal component
   * and the slower of the walls about the others: a lid does not move
   * the fluid in its corners.
   */
  template <int dim>
  class WallConditions
  {
  public:
    /// @p occupancy must outlive the object.
    explicit WallConditions(const Occupancy<dim> &occupancy);

    /// velocity_start from velocity_n, with the walls' at state.time, and what
    /// solids do to it. Collective.
    void
    set_start_velocity(GridState<dim> &state) const;

    /// Fixed components of the displacement such that the fluid has the walls'
    /// velocity at the end of the step, and what solids do to it; @p
    /// rate_offset of the scheme. Collective.
    void
    set_displacement(GridState<dim>                        &state,
                     const StepCoefficients                &coefficients,
                     const typename GridState<dim>::Vector &rate_offset) const;

    /// The ways of solids in the step; @p theta of the scheme. Local.
    void
    set_ways_of_solids(GridState<dim> &state, const double theta) const;

    /// The walls' [m/s] in a direction in which they hold an own node; of a
    /// moving side within a small part of @p dt.
    double
    velocity(const WallDirection<dim> &direction,
             const double              time,
             const double              dt) const;

    /// Displacement [m] of set_displacement() in one direction.
    double
    displacement(const WallDirection<dim>              &direction,
                 const GridState<dim>                  &state,
                 const StepCoefficients                &coefficients,
                 const typename GridState<dim>::Vector &rate_offset) const;

  private:
    /// Of an own node's component that walls fix [m/s].
    double
    component(const unsigned int node,
              const unsigned int component,
              const double       time,
              const double       dt) const;

    /// Side of the domain that decides about an own node's component, or null.
    const Wall<dim> *
    side(const unsigned int node, const unsigned int component) const;

    /// With @p way_of(solid).
    template <typename WayOf>
    void
    set_solids(GridState<dim> &state, const WayOf &way_of) const;

    const Occupancy<dim> &occupancy;
    const bool            moving;
  };
} // namespace seiche

#endif
