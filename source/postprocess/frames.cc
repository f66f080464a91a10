// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/frames.h>
#include <seiche/postprocess/grid_output.h>
#include <seiche/postprocess/paraview_state.h>
#include <seiche/postprocess/point_output.h>
#include <seiche/postprocess/point_series.h>
#include <seiche/postprocess/surface_output.h>
#include <seiche/postprocess/walls_output.h>
#include <seiche/scene/entry_values.h>

namespace seiche
{
  template <int dim>
  void
  make_frames(const PostprocessorContext<dim> &context,
              const OutputParameters          &output,
              Postprocessors<dim>             &list)
  {
    if (context.directory.empty() || output.interval == 0.)
      return;
    const FrameSettings settings{context.directory,
                                 output.interval,
                                 entry_values::number(context.input,
                                                      "Time/End time",
                                                      context.input.value(
                                                        "Time/End time"))};
    if (output.grid)
      list.push_back(std::make_unique<GridOutput<dim>>(settings,
                                                       context.pressure,
                                                       context.communicator));
    if (output.points)
      list.push_back(
        std::make_unique<PointOutput<dim>>(settings, context.communicator));
    if (output.surface)
      list.push_back(
        std::make_unique<SurfaceOutput<dim>>(settings, context.communicator));
    if (output.series)
      list.push_back(
        std::make_unique<PointSeries<dim>>(settings, context.communicator));
    list.push_back(std::make_unique<WallsOutput<dim>>(settings,
                                                      context.grid,
                                                      context.communicator));
    list.push_back(std::make_unique<ParaViewState<dim>>(context.directory,
                                                        context.communicator));
  }

  template void
  make_frames(const PostprocessorContext<2> &,
              const OutputParameters &,
              Postprocessors<2> &);
  template void
  make_frames(const PostprocessorContext<3> &,
              const OutputParameters &,
              Postprocessors<3> &);
} // namespace seiche
