// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_fluid_extent_h
#define seiche_postprocess_fluid_extent_h

#include <seiche/postprocess/postprocessor.h>

#include <limits>
#include <memory>

namespace seiche
{
  /**
   * @brief How far the fluid reaches at the end of a step: what fronts, gauges
   * and run-ups read.
   *
   * With cut cells its end is the reconstructed surface (moved_surface()), or
   * the walls where it touches them, and loose points are spray; else it is
   * half the initial spacing beyond the outermost points. All values are those
   * of this rank; vertical is the last direction.
   */
  template <int dim>
  class FluidExtent
  {
  public:
    /// In place of a coordinate: there is no fluid.
    static constexpr double none = -std::numeric_limits<double>::max();

    virtual ~FluidExtent() = default;

    /// Largest @p sign x_axis [m] of the fluid at heights from @p lowest on.
    virtual double
    farthest(const unsigned int axis,
             const double       sign,
             const double       lowest) const = 0;

    /// Height of the fluid [m] at a place whose vertical coordinate is ignored;
    /// @p width: of what single points stand for, on either side.
    virtual double
    level(const dealii::Point<dim> &place, const double width) const = 0;

    /// Largest height at which a wall, of this boundary id, is wet [m].
    virtual double
    wet_height(const dealii::types::boundary_id wall) const = 0;

    /// The first three, of spray alone.
    virtual double
    farthest_spray(const unsigned int axis,
                   const double       sign,
                   const double       lowest) const = 0;
    virtual double
    spray_level(const dealii::Point<dim> &place, const double width) const = 0;
    virtual double
    spray_height(const dealii::types::boundary_id wall) const = 0;

    /// Integrals over the free surface.
    struct Surface
    {
      double area   = 0.; ///< of its horizontal projection [m^(dim-1)]
      double volume = 0.; ///< between it and the height zero [m^dim]
    };
    virtual Surface
    surface() const = 0;
  };

  /// THE choice of what the fluid's end is. @p view must outlive the object.
  template <int dim>
  std::unique_ptr<FluidExtent<dim>>
  make_fluid_extent(const StepView<dim> &view);

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
        extent = make_fluid_extent(view);
      return *extent;
    }

  private:
    std::unique_ptr<FluidExtent<dim>> extent;
  };
} // namespace seiche

#endif
