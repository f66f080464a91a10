// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_grid_output_h
#define seiche_postprocess_grid_output_h

#include <seiche/postprocess/frame_series.h>
#include <seiche/postprocess/nodal_pressure.h>
#include <seiche/postprocess/postprocessor.h>

#include <memory>

namespace seiche
{
  /**
   * @brief The occupied cells with the fields of the step for ParaView:
   * grid_NNNNNN.vtu and grid.pvd.
   *
   * Cells lie where they were at the start of the step; the displacement of
   * the step is among the fields, so that ParaView can warp by it.
   */
  template <int dim>
  class GridOutput : public Postprocessor<dim>
  {
  public:
    GridOutput(const FrameSettings                       &settings,
               const std::shared_ptr<NodalPressure<dim>> &nodal_pressure,
               const MPI_Comm                             communicator);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    FrameSeries                               series;
    const std::shared_ptr<NodalPressure<dim>> pressure;
  };
} // namespace seiche

#endif
