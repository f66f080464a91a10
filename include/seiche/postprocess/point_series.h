// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_point_series_h
#define seiche_postprocess_point_series_h

#include <seiche/postprocess/frame_series.h>
#include <seiche/postprocess/postprocessor.h>

namespace seiche
{
  /**
   * @brief The material points in full precision: points_NNNNNN.h5.
   *
   * One file a frame, written by rank 0 and sorted by id, so that it does not
   * depend on the number of ranks. Datasets: `id`, and every column that
   * the points carry under its name in the table of columns, [n] or
   * [n][components], with attribute `unit`. Attributes of the file: `time`
   * and `pressure_time` [s], `step`, `dim`.
   */
  template <int dim>
  class PointSeries : public Postprocessor<dim>
  {
  public:
    PointSeries(const FrameSettings &settings, const MPI_Comm communicator);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    FrameSeries series;
  };
} // namespace seiche

#endif
