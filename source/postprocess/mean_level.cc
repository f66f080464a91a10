// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/mean_level.h>
#include <seiche/utilities/over_ranks.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  MeanLevel<dim>::MeanLevel(const PostprocessorContext<dim> &context)
    : extent(context.extent)
  {}

  template <int dim>
  void
  MeanLevel<dim>::execute(const StepView<dim> &view,
                          StatisticsTable     &statistics)
  {
    const auto            surface = extent->get(view).fluid->surface();
    std::array<double, 2> sums    = {{surface.area, surface.volume}};
    sum_over_ranks(sums, view.points.communicator);
    if (view.tank != nullptr && view.tank->rotation[dim - 1][dim - 1] <= 0.)
      {
        statistics.set(column, StatisticsTable::missing);
        return;
      }
    // no fluid, or all of it in flight, but for round-off
    const double cell = std::pow(view.occupancy.smallest_extent(), dim - 1);
    const auto [lower, upper] = view.box.get_boundary_points();
    double bottom             = 1.; // its area
    for (unsigned int d = 0; d + 1 < dim; ++d)
      bottom *= upper[d] - lower[d];
    statistics.set(column,
                   sums[0] > 1e-6 * cell ? sums[1] / sums[0] :
                                           lower[dim - 1] + sums[1] / bottom);
  }

  template class MeanLevel<2>;
  template class MeanLevel<3>;
} // namespace seiche
