// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_assembler_h
#define seiche_solve_assembler_h

#include <seiche/algebra/block_matrix.h>
#include <seiche/formulation/formulation.h>
#include <seiche/quadrature/quadrature.h>
#include <seiche/scene/body_force.h>
#include <seiche/solve/ghost_penalty.h>
#include <seiche/solve/step_balance.h>
#include <seiche/utilities/timer_tree.h>

#include <tuple>

namespace seiche
{
  /**
   * @brief Loops over occupied cells and ghost faces: residual and tangent.
   *
   * The system is (tangent) (update) = -(residual). Owns the cell workspace;
   * references must outlive it.
   */
  template <int dim>
  class Assembler
  {
  public:
    using Vector      = typename GridState<dim>::Vector;
    using BlockVector = typename GridState<dim>::BlockVector;

    Assembler(const Formulation<dim> &formulation,
              CellMaterials<dim>     &materials,
              const BodyForce<dim>   &body_force,
              const Quadrature<dim>  &quadrature,
              const NodePattern<dim> &pattern,
              TimerTree              &timer);

    /// Terms (of the formulation), scalars of the step, its start (time and
    /// velocity) and the nodal offsets of acceleration and velocity
    /// (TimeScheme), which must outlive the step; occupancy and pattern stay as
    /// they are until the next begin(). Collective.
    void
    begin(const WeakForm<dim>    &weak_form,
          const StepCoefficients &coefficients,
          const GridState<dim>   &state,
          const Vector           &inertia_offset,
          const Vector           &rate_offset);

    /// Let residual() and tangent() subtract these projections from what
    /// drives the subscales (orthogonal subscales), until the next begin();
    /// nullptr: none. With ghost values; must outlive its use.
    void
    set_projection(const BlockVector *projected);

    /// Formulation::residual_moments summed over the cells. Collective.
    void
    residual_moments(const GridState<dim> &state, BlockVector &sums);

    /// Where the pressure is known up to a constant; null if nowhere (a finite
    /// bulk modulus, no pressure).
    const ClosedChambers<dim> *
    closed_chambers() const;

    /// Residual of the state; the part of fixed components goes to
    /// state.reaction instead, their residual is zero. In closed chambers the
    /// mean of the volume's rows, which no increment changes, is left out.
    /// Collective.
    void
    residual(GridState<dim> &state, BlockVector &residual);

    /// state.reaction alone, from the cells at walls. Collective.
    void
    reactions(GridState<dim> &state);

    /// Derivative of residual() (in closed chambers but for the mean that it
    /// leaves out). Collective.
    void
    tangent(const GridState<dim> &state, BlockMatrix<dim> &matrix);

    /// Of a converged state, before its points move. Collective.
    StepBalance<dim>
    balance(const GridState<dim> &state);

    const StepCoefficients &
    coefficients() const
    {
      return step;
    }

    /// tau, with subscales, of a cell of this size [m] under a body force
    /// [m/s^2], speed zero, with the largest density and viscosity.
    Tau
    reference_tau(const double size, const double force) const
    {
      return formulation.subscales->evaluate(
        tau_arguments(size, occupancy.fe.degree, materials.largest(), force));
    }

    /// True if the residual of the projection has kinks: at solids that the
    /// fluid may leave.
    bool
    has_contact() const
    {
      return walls_may_be_left;
    }

    /// True if rho tau1 is about the same in all cells: the pressure block is
    /// then a scaled copy of the Schur complement. Collective.
    bool
    tau_follows_density() const;

    /// 2 mu c_r over the volume [Pa/m^dim] of own nodes, of which @p mass is
    /// [kg]; empty if there is no viscosity. Volumes count as
    /// @p least_volume [m^dim] at least. Collective.
    std::vector<double>
    viscous_stiffness(const Vector &mass, const double least_volume) const;

    /// Largest body acceleration [m/s^2], zero if no term has it. Collective.
    double
    body_force_scale() const;

    const Formulation<dim> &formulation;
    /// Viscosities of the start velocity, if the terms are viscous.
    CellMaterials<dim> &materials;

  private:
    /// residual() but for closed chambers, of the cells with
    /// is_wanted(cell, unknowns).
    template <typename IsWanted>
    void
    sum_residual(GridState<dim> &state,
                 BlockVector    &residual,
                 const IsWanted &is_wanted);

    void
    add_tangent(const GridState<dim> &state, BlockMatrix<dim> &matrix);

    /// Add a cell's part.
    template <int degree>
    void
    add_balance(const unsigned int    cell,
                const GridState<dim> &state,
                StepBalance<dim>     &balance);

    /// tau1 [m^4/N] of the pressure's ghost penalty on a face: the transient
    /// one for every choice of the subscales' tau, which may be infinite or
    /// zero.
    double
    ghost_tau(const GhostFace &face, const unsigned int degree) const;

    TauArguments
    tau_arguments(const double           size,
                  const unsigned int     degree,
                  const FluidProperties &fluid,
                  const double           force) const
    {
      return {step,
              fluid,
              formulation.volume_law.bulk_modulus,
              size,
              degree,
              /*speed=*/0.,
              force};
    }

    /// Fill the workspace with cell and nodal values.
    template <int degree>
    CellData<dim, degree> &
    gather(const unsigned int cell, const GridState<dim> &state);

    /// What depends on v_0: the speed that tau may have, and a body force that
    /// varies.
    template <int degree>
    void
    gather_start_velocity(const unsigned int cell, const GridState<dim> &state);

    /// The projections of the residuals.
    template <int degree>
    void
    gather_projection(const unsigned int cell);

    /// Values of a body force that varies, at the places that v_0 predicts:
    /// second order, and the tangent does not need the gradient of the
    /// expression.
    template <int degree>
    void
    gather_body_force(
      const double (&start_velocity)[dim][CellData<dim, degree>::n_nodes]);

    /// True if the tangent of a cell full of Gauss points depends on nothing
    /// but its extents: the projection of the start velocity, which is linear.
    bool
    tangents_are_uniform() const;

    /// action(cell, degree) on each occupied cell.
    template <typename Action>
    void
    for_each_cell(const Action &action) const;

    /// Of the terms and the step.
    void
    assemble_ghost_penalty();

    const Quadrature<dim> &quadrature;
    const Fill<dim>       &fill;
    const Occupancy<dim>  &occupancy;
    const BodyForce<dim>  &body_force;
    TimerTree             &timer;
    const WeakForm<dim>   *weak_form;
    double                 time           = 0.;
    const Vector          *inertia_offset = nullptr;
    const Vector          *rate_offset    = nullptr;
    const BlockVector     *projection     = nullptr;
    const bool             needs_start_speed; // tau does
    const bool             walls_may_be_left; // of solids
    StepCoefficients       step;
    GhostPenalty<dim>      ghost_penalty;

    std::tuple<CellData<dim, 1>, CellData<dim, 2>> workspace; // of one cell
  };
} // namespace seiche

#endif
