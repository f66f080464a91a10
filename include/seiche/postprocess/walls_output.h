// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_walls_output_h
#define seiche_postprocess_walls_output_h

#include <seiche/postprocess/frame_series.h>
#include <seiche/postprocess/postprocessor.h>
#include <seiche/scene/background_grid.h>

namespace seiche
{
  /**
   * @brief The sides of the box and the faces of the obstacles for pictures,
   * lines in 2D and rectangles in 3D: walls_NNNNNN.vtu and walls.pvd.
   *
   * "part [-]" is 0 for the box and i for the i-th obstacle of the file; "open
   * [-]" is 1 on open sides. One frame at the start is enough unless sides
   * move.
   */
  template <int dim>
  class WallsOutput : public Postprocessor<dim>
  {
  public:
    WallsOutput(const FrameSettings       &settings,
                const BackgroundGrid<dim> &grid,
                const MPI_Comm             communicator);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

    void
    save_or_load(StateArchive &archive) override;

  private:
    const GridParameters<dim> &parameters;
    const bool                 is_first_rank;
    FrameSeries                series;
  };
} // namespace seiche

#endif
