// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/newton.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A linear solve that stops early is still a step of an inexact Newton
    /// method if it reduces the residual this much.
    constexpr double usable_reduction = 0.3;

    /// Backtracking halves the update until the residual falls, down to this
    /// share of it: impacts turn a drop's velocity within a step.
    constexpr double shortest_step = 1. / 16.;

    /// The tangent is made anew unless the residual is nearer than this share
    /// of the reduction still needed to what the old one promised: the next
    /// iteration then ends as with a new one. The old tangent's error is 2 to
    /// 10 times what the first update met. Measured: doc/performance.md.
    constexpr double tangent_serves_below = 0.1;

    /// Where that was wrong all the same (a few nodes in spray), new tangents
    /// for so many tries of steps.
    constexpr unsigned int tries_after_miss = 8;

    /// Two updates in a row, of new tangents, that leave more than this of the
    /// residual will not end soon: half the step then costs less, if it was not
    /// halved before. Measured: doc/performance.md.
    constexpr double       slow_reduction    = 0.5;
    constexpr unsigned int most_slow_updates = 2;

    /// Of the reduction still needed, what a linear solve is asked for, and
    /// the loosest that it is asked for: a solve that does much more than is
    /// needed excites nodes of little mass. Measured: doc/performance.md.
    constexpr double forcing_share   = 0.5;
    constexpr double loosest_forcing = usable_reduction;

    /// 1 where the denominator is zero: nothing to compare with.
    double
    ratio(const double numerator, const double denominator)
    {
      return denominator > 0. ? numerator / denominator : 1.;
    }
  } // namespace

  void
  NewtonParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Solver");
    prm.add_parameter("Newton tolerance",
                      tolerance,
                      "Each field's residual over its first value at which "
                      "Newton's iteration ends [-]",
                      Patterns::Double(1e-15, 0.5));
    prm.add_parameter("Newton absolute tolerance",
                      absolute_tolerance,
                      "The same over the forces and volumes at work [-]",
                      Patterns::Double(0., 1e-3));
    prm.add_parameter("Newton maximum iterations",
                      maximum_iterations,
                      "Iterations after which a step is repeated with half "
                      "its size; a first try ends earlier where two updates "
                      "in a row leave more than half of the residual",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }

  template <int dim>
  Newton<dim>::Newton(const NewtonParameters  &p,
                      const double             forcing,
                      const LinearSystem<dim> &s,
                      ResidualProjection<dim> &r,
                      WallContact<dim>        &c,
                      BodyCoupling<dim>       *b)
    : parameters(p)
    , first_forcing(forcing)
    , system(s)
    , projection(r)
    , contact(c)
    , bodies(b)
  {}

  template <int dim>
  typename Newton<dim>::Norms
  Newton<dim>::norms(const BlockVector &vector) const
  {
    Norms result;
    result.momentum = vector.block(0).l2_norm();
    if (vector.n_blocks() == 2)
      result.volume = vector.block(1).l2_norm();
    return result;
  }

  template <int dim>
  typename Newton<dim>::Norms
  Newton<dim>::scales(const GridState<dim> &state) const
  {
    const double g     = system.assembler.body_force_scale();
    double       force = 0., volume = 0.;
    for (unsigned int i = 0; i < state.mass.locally_owned_size(); ++i)
      {
        const double m     = state.mass.local_element(i);
        double       speed = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          speed += std::pow(state.velocity_start.local_element(dim * i + c), 2);
        const double f = m * (std::sqrt(speed) / state.dt + g);
        force += f * f;
        volume += m * m;
      }
    const MPI_Comm communicator = state.mass.get_mpi_communicator();
    Norms          result;
    result.momentum = std::sqrt(Utilities::MPI::sum(force, communicator));
    result.volume   = std::sqrt(Utilities::MPI::sum(volume, communicator)) /
                    system.assembler.materials.largest().density;
    return result;
  }

  template <int dim>
  double
  Newton<dim>::move(GridState<dim> &state,
                    const double    before,
                    const bool      only_nearer)
  {
    double length = 1., done = 0.;
    while (true)
      {
        state.solution.zero_out_ghost_values();
        state.solution.add(length - done, update);
        state.solution.update_ghost_values();
        system.assembler.residual(state, residual);
        const double after = system.solver.norm(residual);
        if (after < before || length == 0. ||
            (length <= shortest_step && !only_nearer))
          return after;
        done   = length;
        length = length > shortest_step ? 0.5 * length : 0.;
      }
  }

  template <int dim>
  std::string
  Newton<dim>::reason_to_stop(const Progress    &progress,
                              const unsigned int iterations) const
  {
    const bool may_go_on = iterations < parameters.maximum_iterations;
    const bool is_slow   = progress.slow_in_row >= progress.most_slow;
    if (may_go_on && !is_slow && progress.is_finite())
      return "";
    const std::string text =
      fmt::format("Newton {} after {} iterations, residual",
                  is_slow && may_go_on ? "hardly converged" : "stopped",
                  iterations);
    const double momentum =
      ratio(progress.now.momentum, progress.first.momentum);
    if (residual.n_blocks() == 1)
      return fmt::format("{} {:.1e} of its first value", text, momentum);
    return fmt::format("{}s {:.1e} and {:.1e} of their first values",
                       text,
                       momentum,
                       ratio(progress.now.volume, progress.first.volume));
  }

  template <int dim>
  double
  Newton<dim>::model_error()
  {
    system.matrix.vmult(product, update);
    product -= residual_change;
    return system.solver.norm(product);
  }

  template <int dim>
  void
  Newton<dim>::plan_next(Progress    &progress,
                         const double reduction,
                         const double before)
  {
    const double needed =
      std::min(ratio(progress.target.momentum, progress.now.momentum),
               ratio(progress.target.volume, progress.now.volume));
    // what an old tangent leaves says little about a new one
    const bool is_slow   = reduction > slow_reduction && !progress.reused;
    progress.slow_in_row = is_slow ? progress.slow_in_row + 1 : 0;
    progress.reuse       = progress.may_reuse && !progress.is_done() &&
                     model_error() < tangent_serves_below * needed * before;
    // never ask the next solve for much more than is left to gain
    const double enough = std::min(forcing_share * needed, loosest_forcing);
    progress.forcing    = std::clamp(0.9 * reduction * reduction,
                                  enough,
                                  std::max(enough, first_forcing));
  }

  template <int dim>
  void
  Newton<dim>::set_target(Progress &progress, const GridState<dim> &state) const
  {
    Norms &first      = progress.first;
    first.momentum    = std::max(first.momentum, progress.now.momentum);
    first.volume      = std::max(first.volume, progress.now.volume);
    const Norms scale = scales(state);
    progress.target   = {std::max(parameters.tolerance * first.momentum,
                                parameters.absolute_tolerance * scale.momentum),
                         std::max(parameters.tolerance * first.volume,
                                parameters.absolute_tolerance * scale.volume)};
  }

  template <int dim>
  typename Newton<dim>::Progress
  Newton<dim>::begin(GridState<dim> &state, const IfUnconverged then)
  {
    residual.reinit(state.solution);
    update.reinit(state.solution);
    residual_change.reinit(state.solution);
    product.reinit(state.solution);
    projection.begin(state);
    system.assembler.residual(state, residual);

    Progress progress;
    progress.now = norms(residual);
    set_target(progress, state);
    progress.begin(first_forcing);
    progress.most_slow = then == IfUnconverged::give_up_early ?
                           most_slow_updates :
                           parameters.maximum_iterations;
    progress.may_reuse = tries_with_new_tangents == 0;
    if (!progress.may_reuse)
      --tries_with_new_tangents;
    return progress;
  }

  template <int dim>
  void
  Newton<dim>::iterate(GridState<dim> &state,
                       const bool      only_nearer,
                       Progress       &progress,
                       NewtonResult   &result)
  {
    if (progress.reused)
      {
        progress.reuse = progress.may_reuse = false;
        tries_with_new_tangents             = tries_after_miss;
      }
    if (!progress.reuse)
      system.linearize(state);
    progress.reused     = progress.reuse;
    const double before = system.solver.norm(residual);
    residual *= -1.;
    const LinearResult linear =
      system.solver.solve(update, residual, progress.forcing);
    result.krylov_iterations += linear.iterations;
    ++result.iterations;
    if (!linear.is_usable(usable_reduction))
      {
        result.failure = linear.problem();
        return;
      }
    residual_change    = residual; // of the old one, negative
    const double after = move(state, before, only_nearer);
    if (only_nearer && !(after < before))
      {
        result.failure =
          fmt::format("Newton's update {} does not reduce the residual",
                      result.iterations);
        result.is_usable = std::isfinite(after);
        return;
      }
    residual_change += residual;
    const bool is_projected =
      projection.update(state, result.iterations - progress.of_other_bodies);
    if (is_projected)
      system.assembler.residual(state, residual);
    progress.now = norms(residual);
    plan_next(progress, after / before, before);
    if (is_projected) // what is left is not the tangent's fault
      progress.reused = false;
  }

  template <int dim>
  NewtonResult
  Newton<dim>::solve(GridState<dim> &state, const IfUnconverged then)
  {
    NewtonResult result;
    Progress     progress = begin(state, then);
    while (true)
      {
        const bool is_finite = progress.is_finite();
        result.is_usable     = is_finite && result.iterations > 0;
        const bool may_correct =
          is_finite && (result.iterations > 0 || progress.is_done());
        const bool walls_differ = may_correct && contact.correct(state);
        const bool bodies_differ =
          may_correct && !walls_differ && progress.is_done() &&
          bodies != nullptr && bodies->correct(state, progress.target.momentum);
        if (walls_differ || bodies_differ)
          {
            system.assembler.residual(state, residual);
            progress.now = norms(residual);
            if (bodies_differ)
              {
                set_target(progress, state); // the first guess had less forces
                progress.of_other_bodies = result.iterations;
              }
            progress.begin(first_forcing); // another problem
          }
        if (progress.is_done() && !bodies_differ)
          break;
        result.failure =
          bodies != nullptr && bodies->is_lost() ?
            "the acceleration of a body that the fluid moves is not found: a "
            "Load that jumps must be smoothed" :
            reason_to_stop(progress,
                           result.iterations - progress.of_other_bodies);
        if (result.failure.empty())
          iterate(state, then == IfUnconverged::take_nearest, progress, result);
        if (!result.failure.empty())
          return result;
      }
    result.converged = true;
    return result;
  }

  template class Newton<2>;
  template class Newton<3>;
} // namespace seiche
