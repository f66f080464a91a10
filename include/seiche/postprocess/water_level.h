// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_water_level_h
#define seiche_postprocess_water_level_h

#include <seiche/postprocess/postprocessor_context.h>

#include <limits>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Gauge NAME".
  template <int dim>
  struct GaugeParameters
  {
    static constexpr const char *kind = "Gauge";

    std::string        name;
    dealii::Point<dim> position; ///< [m], vertical coordinate ignored
    double width = 0.;           ///< [m], 0: the smallest horizontal cell edge

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;
  };

  /**
   * @brief Height of the water at a place, as a wave gauge sees it.
   *
   * The level is that of the fluid (FluidExtent); if there is none that of the
   * bottom, of the domain or of a solid that stands on it. A gauge on a wall
   * that moves goes with it. The spray, if it is above it, is the highest
   * within the width on either side (in every horizontal direction). The depth
   * is a mean of the volume of water per area, which a single drop hardly
   * changes, with weights that fall linearly to zero at that distance (with
   * equal weights the depth of still water depended on where the gauge stood
   * between the points). Beside an obstacle that stands on the bottom, water
   * and area beside it count; on it, those over it. Vertical is the last
   * direction.
   */
  template <int dim>
  class WaterLevel : public Postprocessor<dim>
  {
  public:
    using Parameters = GaugeParameters<dim>;

    WaterLevel(const std::vector<Parameters>   &parameters,
               const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    using Obstacle = Wall<dim>;

    /// What a gauge sees from above.
    struct Footprint
    {
      bool   on_obstacle; ///< that alone, else only what is beside obstacles
      double area;        ///< integral of the weights over that [m^(dim-1)]
    };

    /// Of the points of this rank [m].
    double
    mean_depth(const StepView<dim>      &view,
               const dealii::Point<dim> &place,
               const double              width) const;

    using Corners = std::pair<dealii::Point<dim>, dealii::Point<dim>>;

    /// @p domain: corners of the walls' box.
    Footprint
    footprint(const dealii::Point<dim> &position,
              const double              width,
              const Corners            &domain) const;

    bool
    stands_on_bottom(const Obstacle &obstacle) const;

    /// True over an obstacle that stands on the bottom, its edges left out.
    bool
    is_over_obstacle(const dealii::Point<dim> &place) const;

    const std::vector<GaugeParameters<dim>>       gauges;
    const GridParameters<dim>                    &box;
    const std::shared_ptr<FluidExtentOfStep<dim>> extent;
    double default_width = std::numeric_limits<double>::max(); ///< [m]
  };
} // namespace seiche

#endif
