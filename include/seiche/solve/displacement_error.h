// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_displacement_error_h
#define seiche_solve_displacement_error_h

#include <seiche/grid/grid_state.h>

namespace seiche
{
  /**
   * @brief Estimate of the local error of a step's displacements [m], root
   * mean square over the mass: @p error_constant dt^3 |d^2v/dt^2|, with the
   * change of the acceleration since the step before over @p interval [s] as
   * d^2v/dt^2 (doc/theory.md (3.4)).
   *
   * The state holds both accelerations: acceleration_n from the points,
   * acceleration_np1 of the step. Collective.
   */
  template <int dim>
  double
  displacement_error(const GridState<dim>       &state,
                     const NodeConstraints<dim> &constraints,
                     const double                error_constant,
                     const double                interval);
} // namespace seiche

#endif
