// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_wall_contact_h
#define seiche_grid_wall_contact_h

#include <seiche/grid/cell_materials.h>
#include <seiche/grid/closed_chambers.h>
#include <seiche/grid/row_mass.h>
#include <seiche/grid/wall_conditions.h>
#include <seiche/scene/body_force.h>

#include <vector>

namespace seiche
{
  /**
   * @brief Decides which nodes the fluid holds to unilateral walls, and which
   * are free to leave them.
   *
   * For the normal component of a node on such a wall, n into the fluid: 0 <=
   * n.(v_1 - v_wall) _|_ n.R >= 0, R the reaction (doc/theory.md (8.3)). A
   * primal-dual active set (Hueeber and Wohlmuth 2005): after each Newton
   * iteration components with a tensile reaction are released, those that would
   * penetrate are fixed again; a component that was released twice in a step
   * and penetrates stays fixed. The condition is one on velocities (Moreau
   * 1988): on displacements, a fluid that the step stops at the wall would
   * bounce back from it. The projection of the start velocity has the same
   * condition with impulses; the old pressure's counts as part of them, for it
   * will press during the step.
   *
   * In chambers full of an incompressible fluid the pressure is known up to a
   * constant only: there all nodes stay fixed.
   */
  template <int dim>
  class WallContact
  {
  public:
    using Vector = typename GridState<dim>::Vector;

    /// References must outlive the object.
    WallContact(const WallConditions<dim> &conditions,
                Occupancy<dim>            &occupancy,
                const RowMass<dim>        &row_mass,
                const BodyForce<dim>      &body_force,
                const CellMaterials<dim>  &materials);

    /// True if there are unilateral walls.
    bool
    any() const
    {
      return exists;
    }

    /// Begin an attempt at a step: free is what moves from the wall faster
    /// than the old pressure stops it. @p closed: where the pressure is known up
    /// to a constant; null if nowhere. Collective.
    void
    begin(const GridState<dim> &state, const ClosedChambers<dim> *closed);

    /// Correct the set after a projection of velocity_start with
    /// state.reaction = (impulse)/dt. True if it has changed. Collective.
    bool
    correct_start(const GridState<dim> &state);

    /// Before Newton's iteration; @p rate_offset must outlive it.
    void
    begin_iteration(const StepCoefficients &coefficients,
                    const Vector           &rate_offset);

    /// Correct the set by the displacement and reactions of an iterate, and
    /// the displacement of components that are fixed again. True if something
    /// has changed. Collective.
    bool
    correct(GridState<dim> &state);

  private:
    /// Own node on unilateral walls.
    struct Contact
    {
      WallDirection<dim> direction;
      double             inward; ///< +1 or -1: side of the fluid
      double             extent; ///< [m] of the cell, normal to the wall
      /// Integral of the node's shape function along the normal [m]: its
      /// volume over its area of the wall.
      double       width;
      double       pressing; ///< [N] least force to the wall, from old pressure
      double       margin;   ///< [N] tension below it is round-off
      unsigned int releases; ///< in this solve
    };

    /// Contacts of the nodes as they are numbered, and lie, in this step.
    void
    collect(const ClosedChambers<dim> *closed);

    /// The rule for one: @p force on the fluid [N] if it is fixed, @p way that
    /// it moves from the wall [m] if it is free. True if it changes.
    bool
    change(Contact &contact, const double force, const double way);

    /// True if some rank has @p changed; ghosts are told. Collective.
    bool
    agree(const bool changed);

    const WallConditions<dim> &conditions;
    Occupancy<dim>            &occupancy;
    const RowMass<dim>        &row_mass;
    const BodyForce<dim>      &body_force;
    const CellMaterials<dim>  &materials;
    const bool                 exists;
    unsigned int               projections = 0; ///< of this attempt
    std::vector<Contact>       contacts;
    StepCoefficients           coefficients;
    const Vector              *rate_offset = nullptr;
  };
} // namespace seiche

#endif
