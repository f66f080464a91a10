// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/mean_level.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/mpi.h>

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
    const auto           &fluid   = *extent->get(view).fluid;
    const auto            surface = fluid.surface();
    std::array<double, 2> sums    = {{surface.area, surface.volume}};
    sum_over_ranks(sums, view.points.communicator);
    const double top =
      Utilities::MPI::max(fluid.farthest(dim - 1, /*sign=*/1., fluid.none),
                          view.points.communicator);
    if (view.tank != nullptr && view.tank->rotation[dim - 1][dim - 1] <= 0.)
      {
        statistics.set(column, StatisticsTable::missing);
        return;
      }
    const auto [lower, upper] = view.box.get_boundary_points();
    double bottom             = 1.; // its area
    for (unsigned int d = 0; d + 1 < dim; ++d)
      bottom *= upper[d] - lower[d];
    // a jet or a drop in flight has as much surface below as above
    const double level = sums[1] / sums[0];
    const bool   lies  = sums[0] > 0. && level >= lower[dim - 1] &&
                      level <= top + view.occupancy.smallest_extent();
    statistics.set(column, lies ? level : lower[dim - 1] + sums[1] / bottom);
  }

  template class MeanLevel<2>;
  template class MeanLevel<3>;
} // namespace seiche
