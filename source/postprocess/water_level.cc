// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/place_with_walls.h>
#include <seiche/postprocess/water_level.h>
#include <seiche/scene/wall_slack.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Integral over lower < x < upper of the hat that falls from 1 at x = @p
    /// top to 0 at the distance @p width.
    double
    hat_integral(const double top,
                 const double width,
                 const double lower,
                 const double upper)
    {
      const auto from_top = [width](const double distance) {
        const double x = std::clamp(distance, -width, width);
        return x * (1. - 0.5 * std::abs(x) / width);
      };
      return std::max(0., from_top(upper - top) - from_top(lower - top));
    }

    /// The bottom of the domain at a place, or the solid that stands on it [m].
    template <int dim>
    double
    bottom(const StepView<dim> &view, Point<dim> place)
    {
      constexpr unsigned int most_steps = 1000;
      constexpr double       at_surface = 1e-6; // of the domain's height
      const auto            &solids     = view.occupancy.locator.solids;
      const auto            &corners    = view.box.get_boundary_points();
      const double           top        = corners.second[dim - 1];
      const double slack = at_surface * (top - corners.first[dim - 1]);
      place[dim - 1]     = corners.first[dim - 1];
      if (!solids.empty())
        for (unsigned int i = 0; i < most_steps && place[dim - 1] < top; ++i)
          {
            // no surface is nearer than that
            const double depth = -distance_from(solids, place);
            if (!(depth > slack))
              break;
            place[dim - 1] = std::min(top, place[dim - 1] + depth);
          }
      return place[dim - 1];
    }
  } // namespace

  template <int dim>
  void
  GaugeParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Position",
                      position,
                      "Place of the gauge; its vertical (last) coordinate is "
                      "ignored; with a side that moves it goes. [m]",
                      *Patterns::Tools::Convert<Point<dim>>::to_pattern(),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Width",
                      width,
                      "Of the points those within this distance on either "
                      "side count: as spray, without cut cells as fluid, and "
                      "in the depth with weights that fall to zero there; 0: "
                      "the smallest horizontal cell edge at the start. [m]",
                      Patterns::Double(0.));
  }

  template <int dim>
  void
  GaugeParameters<dim>::check(const InputFile           &input,
                              const GridParameters<dim> &box) const
  {
    for (unsigned int d = 0; d + 1 < dim; ++d)
      {
        const double slack = wall_slack(box.domain().side_length(d));
        input.require(position[d] >= box.lower_corner[d] - slack &&
                        position[d] <= box.upper_corner[d] + slack,
                      std::string(kind) + " " + name + "/Position",
                      "the gauge stands outside the domain; its horizontal "
                      "coordinates must lie between the corners of \"Grid\".");
      }
  }

  template <int dim>
  std::vector<std::string>
  GaugeParameters<dim>::columns() const
  {
    return {"gauge " + name + " [m]",
            "depth " + name + " [m]",
            "gauge " + name + " spray [m]"};
  }

  template <int dim>
  WaterLevel<dim>::WaterLevel(const std::vector<Parameters>   &parameters,
                              const PostprocessorContext<dim> &context)
    : gauges(parameters)
    , box(context.grid.parameters)
    , extent(context.extent)
  {
    const BackgroundGrid<dim> &grid = context.grid;
    // of the grid as it was: points keep their distances when walls move
    const unsigned int levels = grid.finest_level() - grid.lattice_level();
    for (unsigned int d = 0; d + 1 < dim; ++d)
      for (const auto &segment : grid.segments(d))
        default_width =
          std::min(default_width,
                   (segment.end - segment.begin) / (segment.cells << levels));
  }

  template <int dim>
  bool
  WaterLevel<dim>::stands_on_bottom(const Obstacle &obstacle) const
  {
    const double bottom = box.lower_corner[dim - 1];
    return obstacle.lower_corner[dim - 1] <=
           bottom + wall_slack(box.upper_corner[dim - 1] - bottom);
  }

  template <int dim>
  bool
  WaterLevel<dim>::is_over_obstacle(const Point<dim> &place) const
  {
    const auto is_inside = [&](const Obstacle &obstacle) {
      for (unsigned int d = 0; d + 1 < dim; ++d)
        {
          const double lower = obstacle.lower_corner[d],
                       upper = obstacle.upper_corner[d],
                       slack = wall_slack(box.domain().side_length(d));
          if (place[d] < lower + slack || place[d] > upper - slack)
            return false;
        }
      return true;
    };
    for (const auto &obstacle : box.obstacles())
      if (stands_on_bottom(obstacle) && is_inside(obstacle))
        return true;
    return false;
  }

  template <int dim>
  typename WaterLevel<dim>::Footprint
  WaterLevel<dim>::footprint(const Point<dim> &position,
                             const double      width,
                             const Corners    &domain) const
  {
    const auto under = [&](const Point<dim> &lower, const Point<dim> &upper) {
      double result = 1.;
      for (unsigned int d = 0; d + 1 < dim; ++d)
        {
          const double length = domain.second[d] - domain.first[d];
          double       sum    = 0.; // over the images across a seam
          for (const int period : {-1, 0, 1})
            if (period == 0 || box.is_periodic(d))
              sum += hat_integral(position[d] + period * length,
                                  width,
                                  std::max(lower[d], domain.first[d]),
                                  std::min(upper[d], domain.second[d]));
          result *= sum;
        }
      return result;
    };
    const double whole    = under(domain.first, domain.second);
    double       obstacle = 0.;
    for (const auto &o : box.obstacles())
      if (stands_on_bottom(o))
        obstacle += under(o.lower_corner, o.upper_corner);
    // between two obstacles that touch there is nothing but round-off
    const bool on_obstacle =
      is_over_obstacle(position) || whole - obstacle < 1e-9 * whole;
    return {on_obstacle, on_obstacle ? obstacle : whole - obstacle};
  }

  template <int dim>
  void
  WaterLevel<dim>::execute(const StepView<dim> &view,
                           StatisticsTable     &statistics)
  {
    const FluidExtent<dim> &ends = extent->get(view);
    std::vector<double>     level; // of the fluid, what it has left, of spray
    std::vector<double>     depth(gauges.size(), 0.);
    for (unsigned int g = 0; g < gauges.size(); ++g)
      {
        const Point<dim> place =
          place_with_walls(view, gauges[g].position, /*theta=*/1.);
        const double width =
          gauges[g].width > 0. ? gauges[g].width : default_width;
        level.push_back(ends.fluid->level(place, width));
        level.push_back(ends.fluid->level_left(
          place_with_walls(view, gauges[g].position, 0.)));
        level.push_back(ends.spray->level(place, width));
        depth[g] = mean_depth(view, place, width);
      }
    const MPI_Comm communicator = view.points.communicator;
    maximum_over_ranks(level, communicator);
    sum_over_ranks(depth, communicator);
    for (unsigned int g = 0; g < gauges.size(); ++g)
      {
        const auto columns = gauges[g].columns();
        // the highest; where there is none, what has just left, or the bottom
        const double *found = &level[3 * g];
        const double  fluid =
          found[0] == Extent<dim>::none ? found[1] : found[0];
        const double water =
          fluid == Extent<dim>::none ?
            bottom(view,
                   place_with_walls(view, gauges[g].position, /*theta=*/1.)) :
            fluid;
        statistics.set(columns[0], water);
        statistics.set(columns[1], depth[g]);
        statistics.set(columns[2], std::max(water, found[2]));
      }
  }

  template <int dim>
  double
  WaterLevel<dim>::mean_depth(const StepView<dim> &view,
                              const Point<dim>    &place,
                              const double         width) const
  {
    const double *volume = view.points.data(PointColumn::initial_volume);
    std::array<const double *, dim - 1> x;
    for (unsigned int d = 0; d + 1 < dim; ++d)
      x[d] = view.points.data(PointColumn::position, d);
    const Footprint foot =
      footprint(place, width, view.box.get_boundary_points());
    double result = 0.;
    for (std::size_t i = 0; i < view.points.size(); ++i)
      {
        Tensor<1, dim> way;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          way[d] = x[d][i] - place[d];
        way           = view.occupancy.locator.periods.shortest(way);
        double weight = 1.;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          weight *= std::max(0., 1. - std::abs(way[d]) / width);
        if (weight > 0. &&
            is_over_obstacle(view.points.position(i)) == foot.on_obstacle)
          result += weight * volume[i] / foot.area;
      }
    return result;
  }

  template struct GaugeParameters<2>;
  template struct GaugeParameters<3>;
  template class WaterLevel<2>;
  template class WaterLevel<3>;
} // namespace seiche
