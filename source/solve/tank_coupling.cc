// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/tank_coupling.h>
#include <seiche/utilities/moment.h>
#include <seiche/utilities/state_archive.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Over the tolerance, below which corrections tell nothing but what the
    /// fluid has not converged.
    constexpr double clear_misfit = 10.;
  } // namespace

  template <int dim>
  TankCoupling<dim>::TankCoupling(TankMotion<dim>      &motion,
                                  const Occupancy<dim> &grid_occupancy,
                                  const double          of_balance)
    : tank(motion)
    , occupancy(grid_occupancy)
    , tolerance(of_balance)
  {}

  template <int dim>
  void
  TankCoupling<dim>::begin(const GridState<dim> &state)
  {
    if (!any())
      return;
    tank.body_to_move().begin(state.time, state.dt);
    const double mass = state.mass.l1_norm();
    inertias.clear();
    arms.clear();
    for (const auto &freedom : tank.body()->freedoms())
      {
        inertias.push_back(inertia_of_fluid(state, freedom.direction));
        arms.push_back(mass > 0. ? std::sqrt(inertias.back() / mass) : 0.);
      }
    misfit_before = 0.;
    n_corrections = 0;
    if (!matrix_serves)
      reset_matrix();
    matrix_serves = false;
  }

  template <int dim>
  void
  TankCoupling<dim>::reset_matrix()
  {
    matrix.reinit(inertias.size(), inertias.size());
    for (unsigned int i = 0; i < inertias.size(); ++i)
      matrix(i, i) = tank.body()->inertia(i) + inertias[i];
  }

  template <int dim>
  void
  TankCoupling<dim>::begin_iteration(const StepCoefficients &coefficients)
  {
    step = coefficients;
  }

  template <int dim>
  double
  TankCoupling<dim>::inertia_of_fluid(const GridState<dim>     &state,
                                      const TankDirection<dim> &direction) const
  {
    double result = 0.;
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        Tensor<1, dim> arm = occupancy.nodes.position(node) - tank.centre;
        if (dim == 3)
          arm[direction.axis()] = 0.;
        result += state.mass.local_element(node) *
                  (direction.is_angle() ? arm.norm_square() : 1.);
      }
    return Utilities::MPI::sum(result, state.mass.get_mpi_communicator());
  }

  template <int dim>
  std::vector<double>
  TankCoupling<dim>::fluid_loads(const GridState<dim> &state) const
  {
    const auto         &freedoms = tank.body()->freedoms();
    std::vector<double> loads(freedoms.size(), 0.);
    const auto          R = tank.at(state.time + step.theta * step.dt).rotation;
    // @p force: of the walls on the fluid
    const auto subtract_at = [&](const Point<dim>     &place,
                                 const Tensor<1, dim> &force) {
      const auto turn = moment(place - tank.centre, force);
      for (unsigned int i = 0; i < loads.size(); ++i)
        {
          const TankDirection<dim> &direction = freedoms[i].direction;
          loads[i] -= direction.is_angle() ? turn[direction.number - dim] :
                                             R[direction.number] * force;
        }
    };
    const auto subtract = [&](const unsigned int    node,
                              const Tensor<1, dim> &force) {
      Point<dim> place = occupancy.nodes.position(node);
      for (unsigned int c = 0; c < dim; ++c)
        place[c] +=
          step.theta * state.displacement().local_element(dim * node + c);
      subtract_at(place, force);
    };
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        Tensor<1, dim> force;
        for (unsigned int c = 0; c < dim; ++c)
          force[c] = state.reaction.local_element(dim * node + c) +
                     state.start_reaction.local_element(dim * node + c);
        if (force.norm_square() > 0.)
          subtract(node, force);
      }
    for (const auto &drag : state.drags)
      subtract(drag.node, drag.force);
    state.for_each_solid_reaction([&](const auto &reaction) {
      subtract_at(reaction.place, reaction.force);
    });
    Utilities::MPI::sum(loads, state.mass.get_mpi_communicator(), loads);
    return loads;
  }

  template <int dim>
  bool
  TankCoupling<dim>::correct(const GridState<dim> &state,
                             const double          fluid_residual)
  {
    if (!any())
      return false;
    TankBody<dim>            &body  = tank.body_to_move();
    const std::vector<double> fluid = fluid_loads(state);
    const unsigned int        n     = fluid.size();
    Vector<double>            imbalance(n);
    double                    misfit = 0.; // over what is allowed
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int direction = body.freedoms()[i].direction.number;
        const double       middle    = state.time + 0.5 * state.dt;
        const double       inertia =
          body.inertia(i) * tank.jet(direction, middle).second;
        const double load = body.load(i);
        imbalance(i)      = inertia - load - fluid[i];
        const double terms =
          std::abs(inertia) + std::abs(load) + std::abs(fluid[i]);
        const double allowed = tolerance * terms + arms[i] * fluid_residual;
        if (allowed > 0.)
          misfit = std::max(misfit, std::abs(imbalance(i)) / allowed);
        body.set_fluid_load(i, fluid[i]);
      }
    if (misfit_before > clear_misfit)
      update_matrix(imbalance);
    misfit_before = misfit;
    matrix_serves = misfit <= 1.;
    if (matrix_serves)
      return false;
    ++n_corrections;
    imbalance_before = imbalance;
    correction.reinit(n);
    FullMatrix<double> inverse(n);
    inverse.invert(matrix);
    if (!std::isfinite(inverse.frobenius_norm()))
      {
        reset_matrix();
        inverse.invert(matrix);
      }
    inverse.vmult(correction, imbalance);
    correction *= -1.;
    for (unsigned int i = 0; i < n; ++i)
      body.set_acceleration(i, body.freedoms()[i].acceleration + correction(i));
    return true;
  }

  template <int dim>
  void
  TankCoupling<dim>::update_matrix(const Vector<double> &imbalance)
  {
    // what the matrix did not foresee
    Vector<double> missed(imbalance);
    missed -= imbalance_before;
    Vector<double> foreseen(imbalance.size());
    matrix.vmult(foreseen, correction);
    missed -= foreseen;
    // inertias make lengths of displacements and angles one
    Vector<double> weighted(correction);
    for (unsigned int i = 0; i < weighted.size(); ++i)
      weighted(i) *= tank.body()->inertia(i);
    const double square = weighted * correction;
    for (unsigned int i = 0; square > 0. && i < missed.size(); ++i)
      for (unsigned int k = 0; k < missed.size(); ++k)
        matrix(i, k) += missed(i) * weighted(k) / square;
  }

  template <int dim>
  void
  TankCoupling<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("tank coupling", [&]() {
      tank.body_to_move().save_or_load(archive);
      std::vector<double> values(matrix.m() * matrix.n());
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = matrix(i / matrix.n(), i % matrix.n());
      archive("matrix", values);
      archive("matrix serves", matrix_serves);
      const unsigned int n = std::lround(std::sqrt(values.size()));
      if (archive.loading() && n > 0)
        {
          matrix.reinit(n, n);
          for (unsigned int i = 0; i < values.size(); ++i)
            matrix(i / n, i % n) = values[i];
        }
    });
  }

  template class TankCoupling<2>;
  template class TankCoupling<3>;
} // namespace seiche
