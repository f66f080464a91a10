// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_mean_level_h
#define seiche_postprocess_mean_level_h

#include <seiche/postprocess/postprocessor_context.h>

namespace seiche
{
  /**
   * @brief Mean height of the free surface over the area that it covers, seen
   * from above: (int z n_z dA + V_loose)/int n_z dA. The lid, where the fluid
   * stands at it, is part of the surface.
   *
   * Where the surface lies over itself the fluid between counts, and so do
   * drops, as if they had fallen: a splash does not change it. If there is
   * no surface, that of all drops over the whole bottom. With material points
   * it is the volume of the points over the whole bottom. Vertical is the last
   * direction, of a tank that moves its own; missing while that does not point
   * upwards (a tank rolled by 90 degrees or more stands on no bottom).
   */
  template <int dim>
  class MeanLevel : public Postprocessor<dim>
  {
  public:
    static constexpr const char *column = "mean level [m]";

    explicit MeanLevel(const PostprocessorContext<dim> &context);

    void
    execute(const StepView<dim> &view, StatisticsTable &statistics) override;

  private:
    const std::shared_ptr<FluidExtentOfStep<dim>> extent;
  };
} // namespace seiche

#endif
