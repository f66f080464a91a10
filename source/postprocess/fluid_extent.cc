// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/extent_of_surface.h>
#include <seiche/postprocess/fluid_extent.h>
#include <seiche/postprocess/outermost_points.h>

namespace seiche
{
  namespace
  {
    constexpr double least_spray = 0.5; // share of a point that is loose

    template <int dim>
    std::unique_ptr<const Extent<dim>>
    find_fluid(const StepView<dim> &view)
    {
      if (view.fill.has_surface())
        return std::make_unique<ExtentOfSurface<dim>>(view);
      return std::make_unique<OutermostPoints<dim>>(
        view, [](unsigned int, unsigned int) { return true; });
    }

    template <int dim>
    std::unique_ptr<const Extent<dim>>
    find_spray(const StepView<dim> &view)
    {
      return std::make_unique<OutermostPoints<dim>>(
        view, [&view](const unsigned int cell, const unsigned int point) {
          if (!view.fill.has_surface())
            return false;
          const double *loose = view.fill.loose_shares(view.points, cell);
          return loose != nullptr && loose[point] >= least_spray;
        });
    }
  } // namespace

  template <int dim>
  FluidExtent<dim>::FluidExtent(const StepView<dim> &view)
    : fluid(find_fluid(view))
    , spray(find_spray(view))
  {}

  template struct FluidExtent<2>;
  template struct FluidExtent<3>;
} // namespace seiche
