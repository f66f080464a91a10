// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/moved_surface.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A piece of the surface without what of it lies in solids.
    template <int dim>
    std::vector<SurfacePiece<dim>>
    outside_of_solids(const SurfacePiece<dim> &piece,
                      const CutWalls<dim>     &walls,
                      const unsigned int       cell)
    {
      if (!walls.cuts(cell))
        return walls.wet_share(cell) > 0. ?
                 std::vector<SurfacePiece<dim>>{piece} :
                 std::vector<SurfacePiece<dim>>();
      std::array<double, dim> inwards;
      for (unsigned int v = 0; v < dim; ++v)
        inwards[v] = -walls.distance_at(cell, piece[v]);
      return parts_inside<dim>(piece, inwards);
    }
  } // namespace

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
        for (const SurfacePiece<dim> &whole :
             surface_pieces<dim>(view.fill.surface().level_in(cell)))
          for (const SurfacePiece<dim> &unit : outside_of_solids<dim>(
                 whole, view.occupancy.mesh_nodes.cut_walls, cell))
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
