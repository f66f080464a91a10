// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_speed_per_cell_h
#define seiche_simulation_speed_per_cell_h

#include <seiche/simulation/problem.h>

namespace seiche
{
  /// Largest speed over the cell edge [1/s], of points and moving walls at
  /// @p time [s]: the Courant number of a step over its size. Collective.
  template <int dim>
  double
  speed_per_cell(const Problem<dim> &problem, const double time);
} // namespace seiche

#endif
