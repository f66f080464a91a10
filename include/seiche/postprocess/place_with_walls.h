// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_place_with_walls_h
#define seiche_postprocess_place_with_walls_h

#include <seiche/postprocess/postprocessor.h>

namespace seiche
{
  /**
   * Where an instrument that was at @p place [m] at the start of the run is at
   * the time t_n + @p theta dt: one on a wall that moves goes with it, others
   * stay.
   */
  template <int dim>
  dealii::Point<dim>
  place_with_walls(const StepView<dim>      &view,
                   const dealii::Point<dim> &place,
                   const double              theta);
} // namespace seiche

#endif
