// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/body_coupling.h>
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
  BodyCoupling<dim>::BodyCoupling(
    const std::vector<RigidMotion<dim> *> &of_bodies,
    const Occupancy<dim>                  &grid_occupancy,
    const double                           of_balance)
    : occupancy(grid_occupancy)
    , motions(of_bodies)
    , tolerance(of_balance)
  {
    for (unsigned int body = 0; body < motions.size(); ++body)
      for (unsigned int i = 0; i < motions[body]->body()->freedoms().size();
           ++i)
        directions.push_back({motions[body],
                              body,
                              i,
                              motions[body]->body()->freedoms()[i].direction});
  }

  template <int dim>
  void
  BodyCoupling<dim>::begin(const GridState<dim> &state)
  {
    for (RigidMotion<dim> *motion : motions)
      motion->body_to_move().begin(state.time, state.dt);
    inertias.clear();
    arms.clear();
    for (const AddedInertia &added : added_inertias(state))
      {
        inertias.push_back(added.inertia);
        arms.push_back(added.mass > 0. ? std::sqrt(added.inertia / added.mass) :
                                         0.);
      }
    stops.begin(find_stops(state), state.dt, directions.size());
    misfit_before = 0.;
    n_corrections = 0;
    if (!matrix_serves)
      reset_matrix();
    matrix_serves = false;
  }

  template <int dim>
  void
  BodyCoupling<dim>::reset_matrix()
  {
    matrix.reinit(inertias.size(), inertias.size());
    for (unsigned int i = 0; i < inertias.size(); ++i)
      matrix(i, i) =
        directions[i].motion->body()->inertia(directions[i].number) +
        inertias[i];
  }

  template <int dim>
  double
  BodyCoupling<dim>::find_imbalance(const GridState<dim> &state,
                                    const double          fluid_residual,
                                    Vector<double>       &imbalance)
  {
    const std::vector<double> fluid  = fluid_loads(state);
    double                    misfit = 0.;
    for (unsigned int i = 0; i < directions.size(); ++i)
      {
        const Direction &direction = directions[i];
        FreeBody<dim>   &body      = direction.motion->body_to_move();
        const double     middle    = state.time + 0.5 * state.dt;
        const double     inertia =
          direction.motion->momentum_rate(direction.number, middle);
        const double load =
          body.load(direction.number) + further_load(direction, state);
        imbalance(i)       = inertia - load - fluid[i];
        const double stop  = stops.forces()(i);
        const double terms = std::abs(inertia) + std::abs(load) +
                             std::abs(fluid[i]) + std::abs(stop);
        const double allowed = tolerance * terms + arms[i] * fluid_residual;
        if (allowed > 0.)
          misfit = std::max(misfit, std::abs(imbalance(i) - stop) / allowed);
        body.set_loads(direction.number, fluid[i], stop);
      }
    if (stops.are_missing(accelerations()))
      misfit = std::max(misfit, 2. * clear_misfit);
    return misfit;
  }

  template <int dim>
  std::vector<double>
  BodyCoupling<dim>::accelerations() const
  {
    std::vector<double> result;
    for (const Direction &direction : directions)
      result.push_back(
        direction.motion->body()->freedoms()[direction.number].acceleration);
    return result;
  }

  template <int dim>
  bool
  BodyCoupling<dim>::correct(GridState<dim> &state, const double fluid_residual)
  {
    const unsigned int n = directions.size();
    Vector<double>     imbalance(n);
    const double misfit = find_imbalance(state, fluid_residual, imbalance);
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
    Vector<double> load(imbalance);
    load *= -1.;
    stops.solve(inverse, load, accelerations());
    load += stops.forces();
    inverse.vmult(correction, load);
    for (unsigned int i = 0; i < n; ++i)
      {
        FreeBody<dim>     &body   = directions[i].motion->body_to_move();
        const unsigned int number = directions[i].number;
        body.set_acceleration(number,
                              body.freedoms()[number].acceleration +
                                correction(i));
      }
    apply(state);
    return true;
  }

  template <int dim>
  void
  BodyCoupling<dim>::update_matrix(const Vector<double> &imbalance)
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
      weighted(i) *=
        directions[i].motion->body()->inertia(directions[i].number);
    const double square = weighted * correction;
    for (unsigned int i = 0; square > 0. && i < missed.size(); ++i)
      for (unsigned int k = 0; k < missed.size(); ++k)
        matrix(i, k) += missed(i) * weighted(k) / square;
  }

  template <int dim>
  void
  BodyCoupling<dim>::accept()
  {
    for (RigidMotion<dim> *motion : motions)
      motion->body_to_move().accept();
  }

  template <int dim>
  void
  BodyCoupling<dim>::save_or_load_body(StateArchive      &archive,
                                       const unsigned int body,
                                       RigidMotion<dim>  &motion)
  {
    archive.section("body " + std::to_string(body),
                    [&]() { motion.body_to_move().save_or_load(archive); });
  }

  template <int dim>
  void
  BodyCoupling<dim>::save_or_load(StateArchive &archive)
  {
    for (unsigned int body = 0; body < motions.size(); ++body)
      save_or_load_body(archive, body, *motions[body]);
    archive.section("coupling", [&]() {
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

  template class BodyCoupling<2>;
  template class BodyCoupling<3>;
} // namespace seiche
