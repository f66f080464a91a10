// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_motion.h>
#include <seiche/scene/largest_wall_speed.h>
#include <seiche/scene/sample_times.h>
#include <seiche/utilities/exceptions.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Corners and middles of a box, which may be flat.
    template <int dim>
    std::vector<Point<dim>>
    corners_and_middles(const BoundingBox<dim> &box)
    {
      std::vector<Point<dim>> result = {Point<dim>()};
      for (unsigned int d = 0; d < dim; ++d)
        {
          const auto before = std::move(result);
          result.clear();
          for (const double share : {0., 0.5, 1.})
            for (Point<dim> x : before)
              {
                x[d] = box.lower_bound(d) + share * box.side_length(d);
                result.push_back(x);
              }
        }
      return result;
    }

    template <int dim>
    double
    speed_along_walls(const GridParameters<dim> &grid, const double end_time)
    {
      double result = 0.;
      for (const Wall<dim> &wall : grid.walls)
        if (wall.slides())
          for (const Point<dim> &x : corners_and_middles(wall.box()))
            try
              {
                for (const double t : sample_times(end_time))
                  result = std::max(result, wall.sliding_velocity(x, t).norm());
              }
            catch (const InputError &)
              {}
      return result;
    }

    template <int dim>
    double
    speed_of_sides(const GridParameters<dim> &grid, const double end_time)
    {
      const GridMotion<dim> motion(grid, end_time);
      double                result = 0., before = 0.;
      if (motion.any())
        for (const double t : sample_times(end_time))
          {
            if (t > before)
              result =
                std::max(result,
                         motion.largest_way(before, t - before) / (t - before));
            before = t;
          }
      return result;
    }

    template <int dim>
    double
    speed_of_solids(const GridParameters<dim> &grid, const double end_time)
    {
      double result = 0., before = 0.;
      if (any_moves(grid.solids))
        for (const double t : sample_times(end_time))
          {
            if (t > before)
              {
                std::vector<Solid<dim>> solids;
                for (const Solid<dim> &solid : grid.solids)
                  solids.push_back(solid.at(before));
                result =
                  std::max(result,
                           largest_way(solids, grid.domain(), t - before) /
                             (t - before));
              }
            before = t;
          }
      return result;
    }

    template <int dim>
    double
    speed_of_tank(const GridParameters<dim> &grid,
                  const TankMotion<dim>     &tank,
                  const double               end_time)
    {
      if (!tank.any())
        return 0.;
      const Point<dim> middle = grid.domain().center();
      const auto       place  = [&](const double t) {
        const TankPose<dim> &pose = tank.at(t);
        return Tensor<1, dim>(pose.displacement +
                              pose.rotation * (middle - tank.centre()));
      };
      const std::vector<double> times = sample_times(end_time);
      Tensor<1, dim>            first;
      double                    result = 0.;
      for (std::size_t i = 1; i < times.size() && end_time > 0.; ++i)
        {
          const Tensor<1, dim> velocity =
            (place(times[i]) - place(times[i - 1])) / (times[i] - times[i - 1]);
          if (i == 1)
            first = velocity;
          result = std::max(result, (velocity - first).norm());
        }
      return result;
    }
  } // namespace



  template <int dim>
  double
  largest_wall_speed(const GridParameters<dim> &grid,
                     const TankMotion<dim>     &tank,
                     const double               end_time)
  {
    return std::max({speed_along_walls(grid, end_time),
                     speed_of_sides(grid, end_time),
                     speed_of_solids(grid, end_time),
                     speed_of_tank(grid, tank, end_time)});
  }



  template double
  largest_wall_speed(const GridParameters<2> &,
                     const TankMotion<2> &,
                     const double);
  template double
  largest_wall_speed(const GridParameters<3> &,
                     const TankMotion<3> &,
                     const double);
} // namespace seiche
