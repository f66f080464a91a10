// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_nodal_pressure_h
#define seiche_postprocess_nodal_pressure_h

#include <seiche/postprocess/postprocessor.h>

namespace seiche
{
  /**
   * @brief Pressure at the nodes, whatever the formulation.
   *
   * In the mixed form the pressure is an unknown and is returned as it is. In
   * the irreducible form points carry it; the nodes get their mass-weighted
   * mean, computed at most once a step and shared by all postprocessors.
   */
  template <int dim>
  class NodalPressure
  {
  public:
    using Vector = typename GridState<dim>::Vector;

    /// Forget the last step. Local.
    void
    begin_step();

    /// Field [n_local()] in Pa at x_n + pressure_theta u, ghosts
    /// included. Collective at the first call of a step: call it on every rank.
    const Vector &
    field(const StepView<dim> &view);

  private:
    Vector mean;
    bool   is_current = false;
  };
} // namespace seiche

#endif
