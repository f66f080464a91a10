// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_postprocessor_context_h
#define seiche_postprocess_postprocessor_context_h

#include <seiche/postprocess/fluid_extent.h>
#include <seiche/postprocess/nodal_pressure.h>
#include <seiche/scene/background_grid.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>

namespace seiche
{
  class InputFile;

  /// What postprocessors may be made from. Scene and grid outlive them.
  template <int dim>
  struct PostprocessorContext
  {
    const InputFile                        &input;
    const BackgroundGrid<dim>              &grid;
    std::shared_ptr<NodalPressure<dim>>     pressure; ///< of the current step
    std::shared_ptr<FluidExtentOfStep<dim>> extent;
    std::string directory; ///< of the results; empty: no files
    MPI_Comm    communicator;

    /// Path of a file among the results; empty if there are none.
    std::string
    file(const std::string &name) const
    {
      return directory.empty() ? "" : directory + "/" + name;
    }

    bool
    is_first_rank() const
    {
      return dealii::Utilities::MPI::this_mpi_process(communicator) == 0;
    }
  };
} // namespace seiche

#endif
