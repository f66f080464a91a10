// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_body_coupling_h
#define seiche_solve_body_coupling_h

#include <seiche/grid/grid_state.h>
#include <seiche/grid/time_scheme.h>
#include <seiche/scene/rigid_motion.h>
#include <seiche/solve/body_stops.h>

namespace seiche
{
  /**
   * @brief Finds the accelerations of bodies that the fluid moves, the tank or
   * solids: in each free direction inertia times acceleration is the load and
   * what the fluid does, which depends on the acceleration (doc/theory.md
   * (8.8)).
   *
   * Once the fluid has converged its force is that for these accelerations; a
   * quasi-Newton step (Broyden 1965) corrects them, and the fluid converges
   * again. The matrix holds what the fluid adds to the inertia and is kept from
   * step to step: one correction a step serves, for bodies that are lighter
   * than the fluid, too.
   */
  template <int dim>
  class BodyCoupling
  {
  public:
    /// @p motions of the bodies, at least one; they and what they refer to must
    /// outlive the object. @p tolerance: of the balance, over the sum of its
    /// terms [-].
    BodyCoupling(const std::vector<RigidMotion<dim> *> &motions,
                 const Occupancy<dim>                  &occupancy,
                 const double                           tolerance);

    virtual ~BodyCoupling() = default;

    /// Begin an attempt at the step of @p state. Collective.
    void
    begin(const GridState<dim> &state);

    /// Before Newton's iteration.
    void
    begin_iteration(const StepCoefficients &coefficients)
    {
      step = coefficients;
    }

    /// Correct the accelerations by the reactions of a converged state, whose
    /// residual is another one then. False if they fit: to the tolerance and to
    /// what the fluid leaves of its own balance, @p fluid_residual [N].
    /// Collective.
    bool
    correct(GridState<dim> &state, const double fluid_residual);

    /// True after more corrections in an attempt than one that converges needs.
    bool
    is_lost() const
    {
      return n_corrections > most_corrections;
    }

    /// The step is done.
    void
    accept();

    void
    save_or_load(StateArchive &archive);

    /// Of one of the bodies, by its number.
    static void
    save_or_load_body(StateArchive      &archive,
                      const unsigned int body,
                      RigidMotion<dim>  &motion);

  protected:
    /// One free direction of a body.
    struct Direction
    {
      RigidMotion<dim>  *motion;
      unsigned int       body;   ///< number
      unsigned int       number; ///< among the body's own
      BodyDirection<dim> way;
    };

    /// What the fluid is guessed to add to the inertia in each direction, and
    /// the mass that moves with a body's [kg]. Collective.
    struct AddedInertia
    {
      double inertia, mass;
    };
    virtual std::vector<AddedInertia>
    added_inertias(const GridState<dim> &state) const = 0;

    /// What the fluid does to the bodies in each direction. Collective.
    virtual std::vector<double>
    fluid_loads(const GridState<dim> &state) const = 0;

    /// Where bodies must not come nearer to something. Collective.
    virtual std::vector<BodyStop>
    find_stops(const GridState<dim> &state) const
    {
      (void)state;
      return {};
    }

    /// What acts beside it and the body's own load.
    virtual double
    further_load(const Direction &direction, const GridState<dim> &state) const
    {
      (void)direction;
      (void)state;
      return 0.;
    }

    /// The accelerations are others now.
    virtual void
    apply(GridState<dim> &state) const
    {
      (void)state;
    }

    std::vector<Direction> directions;
    const Occupancy<dim>  &occupancy;
    StepCoefficients       step;

  private:
    static constexpr unsigned int most_corrections = 30;

    /// The matrix for the guess of what the fluid adds.
    void
    reset_matrix();

    /// The matrix by the last correction and what it has changed.
    void
    update_matrix(const dealii::Vector<double> &imbalance);

    /// Of the bodies, without stops; what of it is allowed at most with them,
    /// over one.
    double
    find_imbalance(const GridState<dim>   &state,
                   const double            fluid_residual,
                   dealii::Vector<double> &imbalance);

    std::vector<double>
    accelerations() const;

    const std::vector<RigidMotion<dim> *> motions;
    const double                          tolerance;
    dealii::FullMatrix<double>            matrix; ///< of imbalance by
                                                  ///< acceleration
    bool matrix_serves = false; ///< the last attempt ended in balance

    // of this attempt
    BodyStops              stops;
    std::vector<double>    inertias; ///< that the fluid may add
    std::vector<double>    arms; ///< 1, of an angle the radius of gyration [m]
    dealii::Vector<double> correction, imbalance_before;
    double                 misfit_before = 0.; ///< over what is allowed
    unsigned int           n_corrections = 0;
  };
} // namespace seiche

#endif
