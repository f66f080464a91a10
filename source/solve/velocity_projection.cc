// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/velocity_projection.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Newmark never forgets an error of the start.
    constexpr double start_tolerance = 1e-8;

    /// Corrections that leave more than this find nothing but round-off.
    constexpr double stagnation = 0.5;

    /// Solves of a projection beside walls that may be left, each with the set
    /// that the one before found; what then moves into a wall meets it in the
    /// step.
    constexpr unsigned int most_sets = 4;

    /// Of forces and volumes at work: what is less is no violation.
    constexpr double round_off = 1e-14;
  } // namespace

  template <int dim>
  VelocityProjection<dim>::VelocityProjection(const LinearSystem<dim> &s,
                                              const double             t)
    : system(s)
    , tolerance(t)
  {}

  template <int dim>
  bool
  VelocityProjection<dim>::is_round_off(const BlockVector    &violation,
                                        const Vector         &inertia_offset,
                                        const GridState<dim> &state) const
  {
    double square = 0.; // of the forces whose difference the rows are
    for (unsigned int i = 0; i < state.mass.locally_owned_size(); ++i)
      for (unsigned int c = 0; c < dim; ++c)
        square += std::pow(state.mass.local_element(i) *
                             inertia_offset.local_element(dim * i + c),
                           2);
    const double forces =
      std::sqrt(Utilities::MPI::sum(square, state.mass.get_mpi_communicator()));
    const double volumes =
      state.mass.l2_norm() / system.assembler.materials.largest().density;
    return violation.block(0).l2_norm() <= round_off * forces &&
           (violation.n_blocks() == 1 ||
            violation.block(1).l2_norm() <= round_off * volumes);
  }

  template <int dim>
  LinearResult
  VelocityProjection<dim>::solve(const WeakForm<dim>    &weak_form,
                                 GridState<dim>         &state,
                                 const StepCoefficients &coefficients,
                                 const Vector           &inertia_offset,
                                 const Vector           &rate_offset,
                                 BlockVector            &solution,
                                 const double            reduction)
  {
    BlockVector violation(state.solution), update(state.solution);
    violation.zero_out_ghost_values();
    const auto find_violation = [&]() {
      state.solution.zero_out_ghost_values();
      state.solution = solution;
      state.solution.update_ghost_values();
      system.assembler.residual(state, violation);
      violation *= -1.;
    };
    system.assembler.begin(
      weak_form, coefficients, state, inertia_offset, rate_offset);
    find_violation();
    system.linearize(state);
    LinearResult result;
    result.converged = is_round_off(violation, inertia_offset, state);
    if (result.converged)
      return result;
    double       left   = system.solver.norm(violation);
    const double target = reduction * left;
    result              = system.solver.solve(update, violation, reduction);
    solution += update;
    const bool has_sets = system.assembler.has_contact();
    if (!result.converged ||
        (reduction >= LinearSolver<dim>::finest_reduction && !has_sets))
      return result;
    for (unsigned int n = 1;; ++n) // until round-off is left
      {
        const double before = left;
        find_violation();
        left                 = system.solver.norm(violation);
        const bool other_set = has_sets && n < most_sets;
        if (left * (other_set ? stagnation : 1.) <= target ||
            (left > stagnation * before && !other_set))
          return result;
        if (other_set)
          system.linearize(state);
        result.iterations +=
          system.solver.solve(update, violation, target / left).iterations;
        solution += update;
      }
  }

  template <int dim>
  void
  VelocityProjection<dim>::find_reactions(GridState<dim>    &state,
                                          const BlockVector &solution)
  {
    state.solution.zero_out_ghost_values();
    state.solution = solution;
    state.solution.update_ghost_values();
    system.assembler.reactions(state);
  }

  template <int dim>
  LinearResult
  VelocityProjection<dim>::apply(GridState<dim> &state,
                                 const bool      with_reactions)
  {
    const double     dt = state.dt;
    StepCoefficients c;
    c.dt      = dt;
    c.theta   = 0.; // linear: no derivative of the configuration
    c.inertia = 1. / (dt * dt);

    Vector inertia_offset(state.velocity_start.get_partitioner());
    inertia_offset.equ(-1. / dt, state.velocity_start);
    inertia_offset.update_ghost_values();
    // from dt v_n: what is left to solve for is its violation alone
    BlockVector solution(state.solution);
    solution = 0.;
    solution.zero_out_ghost_values();
    solution.block(0).equ(dt, state.velocity_start);
    const LinearResult result = solve(*system.assembler.formulation.projection,
                                      state,
                                      c,
                                      inertia_offset,
                                      state.velocity_start,
                                      solution,
                                      tolerance);
    if (with_reactions)
      find_reactions(state, solution);
    state.velocity_start.zero_out_ghost_values();
    state.velocity_start.equ(1. / dt, solution.block(0));
    state.velocity_start.update_ghost_values();
    return result;
  }

  template <int dim>
  LinearResult
  VelocityProjection<dim>::consistent_start(GridState<dim> &state)
  {
    // a_0 and p_0 do not depend on this time; a short one makes the change of
    // shape within it negligible
    const double     dt = 1e-3 * state.dt;
    StepCoefficients c;
    c.dt      = dt;
    c.theta   = 0.; // linear: no derivative of the configuration
    c.inertia = 1. / (dt * dt);

    Vector zero(state.velocity_n.get_partitioner());
    zero.update_ghost_values();
    BlockVector update(state.solution);
    update = 0.;
    const LinearResult result =
      solve(*system.assembler.formulation.consistent_start,
            state,
            c,
            zero,
            state.velocity_start,
            update,
            start_tolerance);
    state.acceleration_n.zero_out_ghost_values();
    state.acceleration_n.equ(1. / (dt * dt), update.block(0));
    state.acceleration_n.update_ghost_values();
    if (state.has_pressure())
      {
        state.pressure_guess.zero_out_ghost_values();
        state.pressure_guess = update.block(1);
        state.pressure_guess.update_ghost_values();
      }
    return result;
  }

  template class VelocityProjection<2>;
  template class VelocityProjection<3>;
} // namespace seiche
