// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/field_patches.h>
#include <seiche/postprocess/walls_output.h>
#include <seiche/space/surface_pieces.h>
#include <seiche/utilities/box_face.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <deal.II/grid/reference_cell.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// One patch for the face of a box.
    template <int dim>
    void
    add_face(FieldPatches<dim - 1, dim> &walls,
             const BoundingBox<dim>     &box,
             const BoxFace               face,
             const unsigned int          part,
             const bool                  is_wall)
    {
      DataOutBase::Patch<dim - 1, dim> patch;
      patch.patch_index    = walls.patches.size();
      patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
      patch.data.reinit(walls.n_rows(), 1u << (dim - 1));
      unsigned int next = 0;
      for (const unsigned int v : GeometryInfo<dim>::vertex_indices())
        if (face.has_vertex(v))
          {
            patch.vertices[next] = box.vertex(v);
            patch.data(0, next)  = part;
            patch.data(1, next)  = is_wall ? 0. : 1.;
            ++next;
          }
      walls.patches.push_back(patch);
    }

    /// The walls of solids in own cells, on this rank: triangles as quads.
    template <int dim>
    void
    add_solids(FieldPatches<dim - 1, dim> &walls,
               const Occupancy<dim>       &occupancy)
    {
      constexpr unsigned int n_corners = 1u << (dim - 1);
      const auto            &solids    = occupancy.mesh_nodes.cut_walls;
      for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
           ++cell)
        if (solids.cuts(cell))
          // negated: a wall along grid lines is in the cells of the fluid
          for (SurfacePiece<dim> piece :
               surface_pieces<dim>(negated<dim>(solids.distance(cell))))
            {
              std::swap(piece[0], piece[1]); // turned to the fluid
              DataOutBase::Patch<dim - 1, dim> patch;
              patch.patch_index    = walls.patches.size();
              patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
              patch.data.reinit(walls.n_rows(), n_corners);
              Point<dim> centre;
              for (unsigned int v = 0; v < dim; ++v)
                centre += Tensor<1, dim>(piece[v]) / dim;
              const double part = -1. - solids.solid_near(cell, centre);
              for (unsigned int v = 0; v < n_corners; ++v)
                {
                  patch.vertices[v] =
                    occupancy.locator.cells.geometry(cell).to_real(
                      piece[std::min<unsigned int>(v, dim - 1)]);
                  patch.data(0, v) = part;
                  patch.data(1, v) = 0.;
                }
              walls.patches.push_back(patch);
            }
    }
  } // namespace

  template <int dim>
  WallsOutput<dim>::WallsOutput(const FrameSettings       &settings,
                                const BackgroundGrid<dim> &grid,
                                const MPI_Comm             communicator)
    : parameters(grid.parameters)
    , is_first_rank(Utilities::MPI::this_mpi_process(communicator) == 0)
    , series(result_names::walls, settings, communicator)
  {}

  template <int dim>
  void
  WallsOutput<dim>::execute(const StepView<dim> &view,
                            StatisticsTable & /*statistics*/)
  {
    if (!series.due(view.time) ||
        (view.step > 0 && !parameters.any_displaced() &&
         !any_moves(parameters.solids)))
      return;
    FieldPatches<dim - 1, dim> walls(view.time, view.step);
    walls.add_scalar("part [-]");
    walls.add_scalar("open [-]");
    if (is_first_rank)
      for (const unsigned int face : GeometryInfo<dim>::face_indices())
        {
          add_face(
            walls, view.box, face, 0, parameters.walls[face].is_closed());
          for (unsigned int i = 0; i < parameters.obstacles().size(); ++i)
            add_face(walls,
                     parameters.obstacles()[i].box(),
                     face,
                     i + 1,
                     /*is_wall=*/true);
        }
    add_solids(walls, view.occupancy);
    series.write_vtu(view.time, walls);
  }

  template <int dim>
  void
  WallsOutput<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("wall frames", [&]() {
      series.save_or_load(archive, {".vtu", ".pvtu"});
    });
  }

  template class WallsOutput<2>;
  template class WallsOutput<3>;
} // namespace seiche
