// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/extent_of_surface.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// All points are fluid, none are spray.
    template <int dim>
    class ExtentOfPoints : public FluidExtent<dim>
    {
    public:
      using FluidExtent<dim>::none;
      using typename FluidExtent<dim>::Surface;

      explicit ExtentOfPoints(const StepView<dim> &step)
        : view(step)
        , all(step, [](unsigned int, unsigned int) { return true; })
      {}

      double
      farthest(const unsigned int axis,
               const double       sign,
               const double       lowest) const override
      {
        return all.farthest(axis, sign, lowest);
      }

      double
      level(const Point<dim> &place, const double width) const override
      {
        return all.level(place, width);
      }

      double
      wet_height(const types::boundary_id wall) const override
      {
        return all.wet_height(wall);
      }

      double
      farthest_spray(const unsigned int,
                     const double,
                     const double) const override
      {
        return none;
      }

      double
      spray_level(const Point<dim> &, const double) const override
      {
        return none;
      }

      double
      spray_height(const types::boundary_id) const override
      {
        return none;
      }

      /// As if the points' water stood on the whole bottom.
      Surface
      surface() const override
      {
        const auto   &box    = view.occupancy.locator.grid.parameters;
        const double *volume = view.points.data(PointColumn::initial_volume);
        Surface       result;
        const bool    first =
          Utilities::MPI::this_mpi_process(view.points.communicator) == 0;
        if (first)
          {
            result.area = 1.;
            for (unsigned int d = 0; d + 1 < dim; ++d)
              result.area *= box.upper_corner[d] - box.lower_corner[d];
            result.volume = result.area * box.lower_corner[dim - 1];
          }
        for (std::size_t p = 0; p < view.points.size(); ++p)
          result.volume += volume[p];
        return result;
      }

    private:
      const StepView<dim>       &view;
      const OutermostPoints<dim> all;
    };
  } // namespace

  template <int dim>
  std::unique_ptr<FluidExtent<dim>>
  make_fluid_extent(const StepView<dim> &view)
  {
    if (view.fill.has_surface())
      return std::make_unique<ExtentOfSurface<dim>>(view);
    return std::make_unique<ExtentOfPoints<dim>>(view);
  }

  template std::unique_ptr<FluidExtent<2>>
  make_fluid_extent(const StepView<2> &);
  template std::unique_ptr<FluidExtent<3>>
  make_fluid_extent(const StepView<3> &);
} // namespace seiche
