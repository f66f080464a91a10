// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/field_patches.h>
#include <seiche/postprocess/moved_surface.h>
#include <seiche/postprocess/surface_output.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/grid/reference_cell.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// One patch for each piece.
    template <int dim>
    FieldPatches<dim - 1, dim>
    make_patches(const StepView<dim> &view)
    {
      FieldPatches<dim - 1, dim> surface(view.time, view.step);
      surface.add_vector("velocity [m/s]");

      GridEvaluation<dim> here(view);
      for (const MovedPiece<dim> &piece : moved_surface(view))
        {
          DataOutBase::Patch<dim - 1, dim> patch;
          patch.patch_index    = surface.patches.size();
          patch.reference_cell = ReferenceCells::get_simplex<dim - 1>();
          patch.data.reinit(surface.n_rows(), dim);
          for (unsigned int v = 0; v < dim; ++v)
            {
              patch.vertices[v] = piece.place[v];
              here.reinit(piece.cell, piece.unit[v]);
              const Tensor<1, dim> velocity =
                here.vector_value(view.state.velocity_np1);
              for (unsigned int d = 0; d < dim; ++d)
                patch.data(d, v) = velocity[d];
            }
          surface.patches.push_back(patch);
        }
      return surface;
    }
  } // namespace

  template <int dim>
  SurfaceOutput<dim>::SurfaceOutput(const FrameSettings &settings,
                                    const MPI_Comm       communicator)
    : series(result_names::surface, settings, communicator)
  {}

  template <int dim>
  void
  SurfaceOutput<dim>::execute(const StepView<dim> &view,
                              StatisticsTable & /*statistics*/)
  {
    if (view.fill.has_surface() && series.due(view.time))
      series.write_vtu(view.time, make_patches(view));
  }

  template <int dim>
  void
  SurfaceOutput<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("surface frames", [&]() {
      series.save_or_load(archive, {".vtu", ".pvtu"});
    });
  }

  template class SurfaceOutput<2>;
  template class SurfaceOutput<3>;
} // namespace seiche
