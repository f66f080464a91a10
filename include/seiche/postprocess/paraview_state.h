// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_paraview_state_h
#define seiche_postprocess_paraview_state_h

#include <seiche/postprocess/postprocessor.h>

#include <mpi.h>

namespace seiche
{
  /**
   * @brief paraview_state.py: a Python state of ParaView that shows the frames
   * of its folder, whichever there are, as water, spray, walls and obstacles.
   *
   * Written at the start of a run only, so that a restart keeps what users
   * have changed in it.
   */
  template <int dim>
  class ParaViewState : public Postprocessor<dim>
  {
  public:
    ParaViewState(const std::string &output_directory,
                  const MPI_Comm     mpi_communicator);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    const std::string directory;
    const MPI_Comm    communicator;
  };
} // namespace seiche

#endif
