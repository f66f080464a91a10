// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_moved_surface_h
#define seiche_postprocess_moved_surface_h

#include <seiche/postprocess/grid_evaluation.h>
#include <seiche/space/surface_pieces.h>

#include <vector>

namespace seiche
{
  /// A piece of the free surface in an own cell.
  template <int dim>
  struct MovedPiece
  {
    unsigned int      cell;
    SurfacePiece<dim> unit;  ///< in the unit cell, at the start of the step
    SurfacePiece<dim> place; ///< at its end [m]
  };

  /// Where a place of the unit cell is at the end of the step [m]; @p here goes
  /// there.
  template <int dim>
  dealii::Point<dim>
  moved_place(const StepView<dim>      &view,
              const unsigned int        cell,
              const dealii::Point<dim> &unit,
              GridEvaluation<dim>      &here);

  /**
   * The free surface at the end of the step: that of its start, from which the
   * step's quadrature follows (Fill::surface()), outside of solids, moved by
   * the displacement. Needs the rule of cut cells. Local.
   */
  template <int dim>
  std::vector<MovedPiece<dim>>
  moved_surface(const StepView<dim> &view);
} // namespace seiche

#endif
