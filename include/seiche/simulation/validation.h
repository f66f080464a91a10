// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_validation_h
#define seiche_simulation_validation_h

#include <seiche/simulation/planned_scene.h>

#include <string>

namespace seiche
{
  /// What --validate answers: print what a run would need, warn of what is
  /// doubtful, draw the scene beside the folder @p output, OUTPUT.svg (a
  /// warning if that fails). No grid, no points. Local.
  template <int dim>
  void
  validate(const PlannedScene<dim> &planned, const std::string &output);
} // namespace seiche

#endif
