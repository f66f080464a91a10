// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_surface_output_h
#define seiche_postprocess_surface_output_h

#include <seiche/postprocess/frame_series.h>
#include <seiche/postprocess/postprocessor.h>

namespace seiche
{
  /**
   * @brief The free surface at the end of the step for ParaView, lines in 2D
   * and triangles in 3D: surface_NNNNNN.vtu and surface.pvd.
   *
   * Without cut cells there is no surface, and no file.
   */
  template <int dim>
  class SurfaceOutput : public Postprocessor<dim>
  {
  public:
    SurfaceOutput(const FrameSettings &settings, const MPI_Comm communicator);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    FrameSeries series;
  };
} // namespace seiche

#endif
