// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_weak_form_h
#define seiche_solve_weak_form_h

#include <seiche/formulation/formulation.h>
#include <seiche/formulation/ghost_penalty.h>
#include <seiche/grid/cell_materials.h>
#include <seiche/scene/body_force.h>

namespace seiche
{
  /// What the equations of a step are made of: the terms in cells, the
  /// materials and body force in them, and the terms at the free surface. All
  /// must outlive this.
  template <int dim>
  struct WeakForm
  {
    const Formulation<dim>      &formulation;
    const CellMaterials<dim>    &materials;
    const BodyForce<dim>        &body_force;
    const FreeSurfaceParameters &free_surface;
  };
} // namespace seiche

#endif
