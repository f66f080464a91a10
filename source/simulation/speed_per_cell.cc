// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/speed_per_cell.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  template <int dim>
  double
  speed_per_cell(const Problem<dim> &problem, const double time)
  {
    const PointCloud<dim> &points  = problem.points;
    double                 largest = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double *velocity = points.data(PointColumn::velocity, d);
        for (const unsigned int cell : problem.occupancy.cells.occupied())
          {
            double speed = 0.;
            for (const std::size_t p : points.points_in(cell))
              speed = std::max(speed, std::abs(velocity[p]));
            largest =
              std::max(largest, speed / problem.locator.cells.reach(cell)[d]);
          }
      }
    // Walls now and over a step, which may take them there and back; one that
    // may move less than the CFL number says is as if it were faster.
    const auto  &parameters = problem.scene.time;
    const double faster =
      std::max(1., parameters.cfl / problem.most_wall_way());
    for (const double dt : {1e-3 * parameters.step, parameters.step})
      largest = std::max(largest, faster * problem.wall_way(time, dt) / dt);
    return dealii::Utilities::MPI::max(largest, problem.communicator);
  }

  template double
  speed_per_cell(const Problem<2> &, const double);
  template double
  speed_per_cell(const Problem<3> &, const double);
} // namespace seiche
