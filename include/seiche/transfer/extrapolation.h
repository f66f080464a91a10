// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_extrapolation_h
#define seiche_transfer_extrapolation_h

#include <seiche/grid/fill.h>
#include <seiche/grid/grid_state.h>

namespace seiche
{
  /**
   * Velocity, and acceleration and pressure, at the vertices of cells with an
   * inside that no cell with an inside and points touches: the mean of what the
   * multilinear fields of the face neighbours (else of all neighbours) whose
   * vertices are known become there (doc/theory.md, section 5, step 5). Linear
   * fields stay what they are. Needs Fill::surface(). Collective.
   */
  template <int dim>
  void
  extrapolate_fields(const PointCloud<dim> &points,
                     const Fill<dim>       &fill,
                     GridState<dim>        &state);
} // namespace seiche

#endif
