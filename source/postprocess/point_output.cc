// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/field_patches.h>
#include <seiche/postprocess/point_output.h>
#include <seiche/utilities/result_names.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int exact_bits = 24; // of a float

    /// One patch of a single vertex for each point.
    template <int dim>
    FieldPatches<0, dim>
    make_patches(const StepView<dim> &view)
    {
      FieldPatches<0, dim> cloud(view.time, view.step);
      cloud.add_vector("velocity [m/s]");
      cloud.add_scalar("pressure [Pa]");
      cloud.add_scalar("volume ratio [-]");
      cloud.add_scalar("mass [kg]");
      cloud.add_scalar("radius [m]");
      for (const char *part : {"low", "middle", "high"})
        cloud.add_scalar(fmt::format("id {} bits", part));
      const PointCloud<dim> &points = view.points;
      const bool several_materials  = points.has(PointColumn::material);
      if (several_materials)
        cloud.add_scalar("material [-]");

      const double *ratio = points.data(PointColumn::volume_ratio);
      const double *v0    = points.data(PointColumn::initial_volume);
      cloud.patches.resize(points.size());
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          DataOutBase::Patch<0, dim> &patch = cloud.patches[i];
          patch.patch_index                 = i;
          patch.vertices[0]                 = points.position(i);
          patch.data.reinit(cloud.n_rows(), 1);
          for (unsigned int d = 0; d < dim; ++d)
            patch.data(d, 0) = points.data(PointColumn::velocity, d)[i];
          patch.data(dim, 0)     = points.data(PointColumn::pressure)[i];
          patch.data(dim + 1, 0) = ratio[i];
          patch.data(dim + 2, 0) = points.data(PointColumn::mass)[i];
          patch.data(dim + 3, 0) = 0.5 * std::pow(ratio[i] * v0[i], 1. / dim);
          for (unsigned int part = 0; part < 3; ++part)
            patch.data(dim + 4 + part, 0) =
              (points.ids()[i] >> (part * exact_bits)) &
              ((std::uint64_t(1) << exact_bits) - 1);
          if (several_materials)
            patch.data(dim + 7, 0) = points.data(PointColumn::material)[i];
        }
      return cloud;
    }
  } // namespace

  template <int dim>
  PointOutput<dim>::PointOutput(const FrameSettings &settings,
                                const MPI_Comm       communicator)
    : series(result_names::points, settings, communicator)
  {}

  template <int dim>
  void
  PointOutput<dim>::execute(const StepView<dim> &view,
                            StatisticsTable & /*statistics*/)
  {
    if (series.due(view.time))
      series.write_vtu(view.time, make_patches(view));
  }

  template <int dim>
  void
  PointOutput<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("point frames", [&]() {
      series.save_or_load(archive, {".vtu", ".pvtu"});
    });
  }

  template class PointOutput<2>;
  template class PointOutput<3>;
} // namespace seiche
