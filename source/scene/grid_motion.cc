// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/grid_motion.h>
#include <seiche/scene/jumps.h>
#include <seiche/scene/sample_times.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    /// Of the room between a moving wall and the next fixed lines, the share
    /// that must be left: thinner cells would cost more than they tell.
    constexpr double least_room = 0.2;

    /// Part of the room that a wall may move between two samples without a
    /// closer look.
    constexpr double slow_share = 0.01;
  } // namespace

  template <int dim>
  GridMotion<dim>::GridMotion(const GridParameters<dim> &grid_parameters,
                              const double               end_time)
    : parameters(grid_parameters)
    , last_time(end_time)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        fixed[d] = {{parameters.upper_corner[d], parameters.lower_corner[d]}};
        for (const auto &obstacle : parameters.obstacles())
          fixed[d] = {{std::min(fixed[d][0], obstacle.lower_corner[d]),
                       std::max(fixed[d][1], obstacle.upper_corner[d])}};
      }
  }

  template <int dim>
  void
  GridMotion<dim>::check(const InputFile &input) const
  {
    for (const Wall<dim> &wall : parameters.walls)
      if (wall.is_displaced())
        check_side(input, wall);
  }

  template <int dim>
  void
  GridMotion<dim>::check_side(const InputFile &input,
                              const Wall<dim> &wall) const
  {
    const std::string  path  = wall.path("displacement");
    const BoxFace      side  = wall.side();
    const unsigned int d     = side.direction();
    const double       place = wall.lower_corner[d];
    const double       end   = parameters.obstacles().size() > 0 ?
                                 fixed[d][side.is_upper()] :
                                 parameters.walls[side.opposite()].lower_corner[d];
    const double       room  = std::abs(end - place);
    input.require(room > 0.,
                  path,
                  "an obstacle stands at this wall; it cannot move.");
    double before = 0.;
    for (const double t : sample_times(last_time))
      {
        const double left =
          side.outward() * (line(d, place, t) - line(d, end, t));
        const bool ordered = line(d, parameters.lower_corner[d], t) <
                             line(d, parameters.upper_corner[d], t);
        input.require(ordered && left >= least_room * room,
                      path,
                      fmt::format("at t = {:.4g} s the wall leaves {:.3g} m of "
                                  "{:.3g} m to the next {}; a fifth is the "
                                  "least.",
                                  t,
                                  std::abs(left),
                                  room,
                                  parameters.obstacles().size() == 0 ?
                                    "wall" :
                                    "obstacle"));
        input.require(
          !jumps([&](const double time) { return wall.displacement(time); },
                 before,
                 t,
                 slow_share * room),
          path,
          fmt::format("the wall jumps between t = {:.4g} s and "
                      "{:.4g} s; an expression without steps is "
                      "needed.",
                      before,
                      t));
        before = t;
      }
  }

  template <int dim>
  bool
  GridMotion<dim>::any() const
  {
    return parameters.any_displaced();
  }

  template <int dim>
  double
  GridMotion<dim>::largest_way(const double time, const double dt) const
  {
    const double end  = std::min(time + dt, last_time); // of tables, too
    double       most = 0.;
    for (const Wall<dim> &wall : parameters.walls)
      most =
        std::max(most,
                 std::abs(wall.displacement(end) - wall.displacement(time)));
    return most;
  }

  template <int dim>
  double
  GridMotion<dim>::line(const unsigned int direction,
                        const double       place,
                        const double       time) const
  {
    // sides and fixed lines; what lies between two of them is stretched
    const double begin = parameters.lower_corner[direction],
                 end   = parameters.upper_corner[direction];
    const auto stands  = [&](const bool upper) {
      return parameters.walls[BoxFace(direction, upper)].displacement(time);
    };
    const double low  = begin + stands(/*upper=*/false);
    const double high = end + stands(/*upper=*/true);
    const auto  &stay = fixed[direction];
    const auto   between =
      [place](const double a, const double b, const double x, const double y) {
        return place == b ? y : x + (place - a) * ((y - x) / (b - a));
      };
    if (stay[0] > stay[1]) // no obstacle
      return between(begin, end, low, high);
    if (place < stay[0])
      return between(begin, stay[0], low, stay[0]);
    if (place > stay[1])
      return between(stay[1], end, stay[1], high);
    return place;
  }

  template <int dim>
  dealii::BoundingBox<dim>
  GridMotion<dim>::box(const double time) const
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = line(d, parameters.lower_corner[d], time);
        upper[d] = line(d, parameters.upper_corner[d], time);
      }
    return dealii::BoundingBox<dim>({lower, upper});
  }

  template class GridMotion<2>;
  template class GridMotion<3>;
} // namespace seiche
