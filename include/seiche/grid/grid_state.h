// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_grid_state_h
#define seiche_grid_grid_state_h

#include <seiche/space/occupancy.h>

#include <deal.II/lac/la_parallel_block_vector.h>

namespace seiche
{
  /**
   * @brief Nodal fields of the current step; the grid carries nothing further.
   *
   * Vector fields have entry dim*node + component, scalar fields entry node,
   * in the compact numbering of NodeNumbering. Ghost entries are valid after
   * points_to_grid and after each Newton update.
   */
  template <int dim>
  struct GridState
  {
    using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /// Adopt the layout of the occupancy and set all fields to zero.
    void
    reinit(const Occupancy<dim> &occupancy,
           const bool            with_pressure,
           const bool            with_acceleration);

    bool
    has_pressure() const
    {
      return solution.n_blocks() == 2;
    }

    /// Mass of the points that do not count for a component of velocity_n [kg].
    double
    unseen(const unsigned int node, const unsigned int component) const
    {
      return unseen_mass.size() > 0 ?
               unseen_mass.local_element(dim * node + component) :
               0.;
    }

    /// Mass of those that do [kg], zero where it is round-off.
    double
    seen_mass(const unsigned int node, const unsigned int component) const
    {
      constexpr double nothing = 1e-12; // of the mass
      const double     all     = mass.local_element(node);
      const double     seen    = all - unseen(node, component);
      return seen > nothing * all ? seen : 0.;
    }

    /// action(reaction) on those of the step and of what made its start.
    template <typename Action>
    void
    for_each_solid_reaction(const Action &action) const
    {
      for (const auto *reactions : {&solid_reactions, &solid_start_reactions})
        for (const SolidReaction<dim> &reaction : *reactions)
          action(reaction);
    }

    double time = 0.; ///< [s] t_n, start of the step
    double dt   = 0.; ///< [s] step size

    Vector mass;       ///< [kg] lumped mass from the points
    Vector velocity_n; ///< [m/s] from the points
    /// Of the points in cells where a component is zero (doc/theory.md (8.0c)),
    /// which velocity_n leaves out: mean [m/s] and mass [kg]; empty: none.
    Vector unseen_velocity, unseen_mass;
    Vector velocity_start;  ///< [m/s] v_0: with walls, projected
    Vector velocity_series, ///< [m/s] XPIC: M^-1 p by its series, or empty;
      unseen_series;        ///< of what velocity_n leaves out
    Vector acceleration_n;  ///< [m/s^2] empty unless the scheme carries it or
                            ///< the step's error is estimated from it

    /// Unknowns: block 0 the displacement since t_n [m], block 1 the pressure
    /// [Pa] (there is no block 1 in the irreducible form).
    BlockVector solution;

    Vector velocity_np1;     ///< [m/s]   end of the step
    Vector acceleration_np1; ///< [m/s^2] of the step (scheme's own meaning)
    Vector pressure_guess;   ///< [Pa] mass-weighted mean of the points
    Vector reaction;         ///< [N] of what fixes components, on the fluid
    Vector start_reaction;   ///< [N] the same of what made v_0 of v_n, its
                             ///< impulse over dt; zero unless forces are
                             ///< measured

    /// What solids do to it, by their number: WallConditions.
    std::vector<SolidInStep<dim>> solids;

    /// Of solids on the fluid, in own cells; of what made v_0 of v_n, the
    /// impulses over dt, if forces are measured.
    std::vector<SolidReaction<dim>> solid_reactions, solid_start_reactions;

    /// Force of a wall's friction on the fluid at an own node [N].
    struct Drag
    {
      unsigned int           node, wall;
      dealii::Tensor<1, dim> force;
    };
    std::vector<Drag> drags;

    Vector &
    displacement()
    {
      return solution.block(0);
    }
    const Vector &
    displacement() const
    {
      return solution.block(0);
    }
    Vector &
    pressure()
    {
      return solution.block(1);
    }
    const Vector &
    pressure() const
    {
      return solution.block(1);
    }
  };
} // namespace seiche

#endif
