// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/moved_surface.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Point<dim>
  moved_place(const StepView<dim> &view,
              const unsigned int   cell,
              const Point<dim>    &unit,
              GridEvaluation<dim> &here)
  {
    here.reinit(cell, unit);
    return here.position() + here.vector_value(view.state.displacement());
  }

  template <int dim>
  std::vector<MovedPiece<dim>>
  moved_surface(const StepView<dim> &view)
  {
    std::vector<MovedPiece<dim>> result;
    GridEvaluation<dim>          here(view);
    for (unsigned int cell = 0; cell < view.occupancy.locator.cells.n_owned();
         ++cell)
      if (view.occupancy.cells.is_active(cell))
        for (const SurfacePiece<dim> &unit :
             surface_pieces<dim>(view.fill.surface().level_in(cell)))
          {
            MovedPiece<dim> piece{cell, unit, {}};
            for (unsigned int v = 0; v < dim; ++v)
              piece.place[v] = moved_place(view, cell, unit[v], here);
            result.push_back(piece);
          }
    return result;
  }

  template Point<2>
  moved_place(const StepView<2> &,
              const unsigned int,
              const Point<2> &,
              GridEvaluation<2> &);
  template Point<3>
  moved_place(const StepView<3> &,
              const unsigned int,
              const Point<3> &,
              GridEvaluation<3> &);
  template std::vector<MovedPiece<2>>
  moved_surface(const StepView<2> &);
  template std::vector<MovedPiece<3>>
  moved_surface(const StepView<3> &);
} // namespace seiche
