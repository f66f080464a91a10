// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_fluid_extent_h
#define seiche_postprocess_fluid_extent_h

#include <seiche/postprocess/extent.h>

#include <memory>

namespace seiche
{
  /**
   * @brief How far the fluid and its spray reach at the end of a step: what
   * fronts, gauges and run-ups read.
   *
   * With cut cells the fluid's end is the reconstructed surface
   * (moved_surface()), or the walls where it touches them, and loose points are
   * spray. Without, it is half the initial spacing beyond the outermost points,
   * and none are spray.
   */
  template <int dim>
  struct FluidExtent
  {
    /// THE choice of what the ends are. @p view must outlive the object.
    explicit FluidExtent(const StepView<dim> &view);

    const std::unique_ptr<const Extent<dim>> fluid, spray;
  };

  /// The extent of the current step, made once for all postprocessors.
  template <int dim>
  class FluidExtentOfStep
  {
  public:
    /// Forget the last step.
    void
    begin_step()
    {
      extent.reset();
    }

    /// Local.
    const FluidExtent<dim> &
    get(const StepView<dim> &view)
    {
      if (extent == nullptr)
        extent = std::make_unique<FluidExtent<dim>>(view);
      return *extent;
    }

  private:
    std::unique_ptr<FluidExtent<dim>> extent;
  };
} // namespace seiche

#endif
