// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_point_output_h
#define seiche_postprocess_point_output_h

#include <seiche/postprocess/frame_series.h>
#include <seiche/postprocess/postprocessor.h>

namespace seiche
{
  /**
   * @brief The material points for ParaView: points_NNNNNN.vtu and points.pvd.
   *
   * "radius" is that of a ball to draw: half the edge of the cube (square)
   * with the volume of the point. VTU holds single precision, which cannot
   * carry a 64-bit id: it is split into three times 24 bits.
   * "material" is there with several materials: the number in the scene's list.
   */
  template <int dim>
  class PointOutput : public Postprocessor<dim>
  {
  public:
    PointOutput(const FrameSettings &settings, const MPI_Comm communicator);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    FrameSeries series;
  };
} // namespace seiche

#endif
