// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_tank_coupling_h
#define seiche_solve_tank_coupling_h

#include <seiche/grid/grid_state.h>
#include <seiche/grid/time_scheme.h>
#include <seiche/scene/tank_motion.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace seiche
{
  /**
   * @brief Finds the acceleration of a tank that the fluid moves: in each free
   * direction inertia times acceleration is the load and what the fluid does,
   * which depends on the acceleration (doc/theory.md (8.8)).
   *
   * Once the fluid has converged its force is that for an acceleration of the
   * tank; a quasi-Newton step (Broyden 1965) corrects this, and the fluid
   * converges again. The matrix holds what the fluid adds to the inertia and is
   * kept from step to step: one correction a step serves, for tanks that are
   * lighter than their fluid, too.
   */
  template <int dim>
  class TankCoupling
  {
  public:
    /// @p tolerance: of the balance, over the sum of its terms [-]. References
    /// must outlive the object.
    TankCoupling(TankMotion<dim>      &tank,
                 const Occupancy<dim> &occupancy,
                 const double          tolerance);

    /// True if the fluid moves the tank.
    bool
    any() const
    {
      return tank.body() != nullptr;
    }

    /// Begin an attempt at the step of @p state. Collective.
    void
    begin(const GridState<dim> &state);

    /// Before Newton's iteration.
    void
    begin_iteration(const StepCoefficients &coefficients);

    /// Correct the acceleration by the reactions of a converged state, whose
    /// residual is another one then. False if it fits: to the tolerance and to
    /// what the fluid leaves of its own balance, @p fluid_residual [N].
    /// Collective.
    bool
    correct(const GridState<dim> &state, const double fluid_residual);

    /// True after more corrections in an attempt than one that converges needs.
    bool
    is_lost() const
    {
      return n_corrections > most_corrections;
    }

    void
    save_or_load(StateArchive &archive);

  private:
    static constexpr unsigned int most_corrections = 30;

    /// Of the fluid at rest in the tank: its mass or moment of inertia.
    double
    inertia_of_fluid(const GridState<dim>     &state,
                     const TankDirection<dim> &direction) const;

    /// What the fluid does to the tank in each free direction. Collective.
    std::vector<double>
    fluid_loads(const GridState<dim> &state) const;

    /// The matrix for a fluid that goes with the tank as a rigid body.
    void
    reset_matrix();

    /// The matrix by the last correction and what it has changed.
    void
    update_matrix(const dealii::Vector<double> &imbalance);

    TankMotion<dim>           &tank;
    const Occupancy<dim>      &occupancy;
    const double               tolerance;
    StepCoefficients           step;
    dealii::FullMatrix<double> matrix; ///< of imbalance by acceleration
    bool matrix_serves = false;        ///< the last attempt ended in balance

    // of this attempt
    std::vector<double>    inertias; ///< of the fluid as a rigid body
    std::vector<double>    arms; ///< 1, of an angle the radius of gyration [m]
    dealii::Vector<double> correction, imbalance_before;
    double                 misfit_before = 0.; ///< over what is allowed
    unsigned int           n_corrections = 0;
  };
} // namespace seiche

#endif
