// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_solids_on_grid_h
#define seiche_simulation_solids_on_grid_h

#include <seiche/parameters/input_file.h>
#include <seiche/space/occupancy.h>

namespace seiche
{
  /// InputError for a solid whose wall cuts no cell, or whose volume on the
  /// grid is far from its own: it is thinner than cells. Collective.
  template <int dim>
  void
  require_solids_on_grid(const Occupancy<dim> &occupancy,
                         const InputFile      &input);
} // namespace seiche

#endif
