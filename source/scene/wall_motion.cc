// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/jumps.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/wall_motion.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    /// Of the room between a moving wall and the next fixed lines, the share
    /// that must be left: thinner cells would cost more than they tell.
    constexpr double least_room = 0.2;

    /// Part of the step over which velocities are differences.
    constexpr double difference = 1e-3;

    /// Part of the room that a wall may move between two samples without a
    /// closer look.
    constexpr double slow_share = 0.01;
  } // namespace

  template <int dim>
  WallMotion<dim>::WallMotion(const GridParameters<dim> &parameters,
                              const InputFile           &input,
                              const double               end_time)
    : last_time(end_time)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        sides[d] = {{parameters.lower_corner[d], parameters.upper_corner[d]}};
        fixed[d] = {{sides[d][1], sides[d][0]}};
        for (const auto &obstacle : parameters.obstacles())
          fixed[d] = {{std::min(fixed[d][0], obstacle.lower_corner[d]),
                       std::max(fixed[d][1], obstacle.upper_corner[d])}};
      }
    for (unsigned int side = 0; side < 2 * dim; ++side)
      {
        const Wall<dim> &wall = parameters.walls[side];
        if (wall.displacement.empty())
          continue;
        const std::string path = wall.path("displacement");
        input.require(wall.condition != WallCondition::open,
                      path,
                      "an open side is no wall; only walls move.");
        expressions[side].emplace(input,
                                  path,
                                  wall.displacement,
                                  /*n_components=*/1,
                                  parameters.lower_corner);
      }
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (moves(side))
        check(parameters, input, side);
  }

  template <int dim>
  void
  WallMotion<dim>::check(const GridParameters<dim> &parameters,
                         const InputFile           &input,
                         const unsigned int         side) const
  {
    const std::string  path = parameters.walls[side].path("displacement");
    const unsigned int d    = side / 2;
    expressions[side]->check_motion(parameters.lower_corner,
                                    parameters.upper_corner,
                                    last_time);
    input.require(displacement(side, /*time=*/0.) == 0.,
                  path,
                  "it must be 0 at t = 0: the wall begins where the grid has "
                  "its side.");
    const double end  = parameters.obstacles().size() > 0 ?
                          fixed[d][side % 2] :
                          sides[d][1 - side % 2];
    const double room = std::abs(end - sides[d][side % 2]);
    input.require(room > 0.,
                  path,
                  "an obstacle stands at this wall; it cannot move.");
    double before = 0.;
    for (const double t : sample_times(last_time))
      {
        const double left =
          std::abs(line(d, end, t) - line(d, sides[d][side % 2], t));
        const bool ordered = line(d, sides[d][0], t) < line(d, sides[d][1], t);
        input.require(ordered && left >= least_room * room &&
                        (line(d, end, t) > line(d, sides[d][side % 2], t)) ==
                          (side % 2 == 0),
                      path,
                      fmt::format("at t = {:.4g} s the wall leaves {:.3g} m of "
                                  "{:.3g} m to the next {}; a fifth is the "
                                  "least.",
                                  t,
                                  left,
                                  room,
                                  parameters.obstacles().size() == 0 ?
                                    "wall" :
                                    "obstacle"));
        input.require(
          !jumps([&](const double time) { return displacement(side, time); },
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
  WallMotion<dim>::any() const
  {
    return std::any_of(expressions.begin(),
                       expressions.end(),
                       [](const auto &e) { return e.has_value(); });
  }

  template <int dim>
  double
  WallMotion<dim>::displacement(const unsigned int side,
                                const double       time) const
  {
    return moves(side) ? expressions[side]->value(dealii::Point<dim>(), time) :
                         0.;
  }

  template <int dim>
  double
  WallMotion<dim>::velocity(const unsigned int side,
                            const double       time,
                            const double       dt) const
  {
    if (!moves(side))
      return 0.;
    // one-sided, of second order: a motion need not be defined before t = 0
    const double h = difference * dt;
    return (-3. * displacement(side, time) + 4. * displacement(side, time + h) -
            displacement(side, time + 2. * h)) /
           (2. * h);
  }

  template <int dim>
  double
  WallMotion<dim>::largest_way(const double time, const double dt) const
  {
    const double end  = std::min(time + dt, last_time); // of tables, too
    double       most = 0.;
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (moves(side))
        most = std::max(most,
                        std::abs(displacement(side, end) -
                                 displacement(side, time)));
    return most;
  }

  template <int dim>
  double
  WallMotion<dim>::line(const unsigned int direction,
                        const double       place,
                        const double       time) const
  {
    // sides and fixed lines; what lies between two of them is stretched
    const auto  &begin = sides[direction];
    const double low =
      begin[0] + displacement(BoxFace(direction, /*upper=*/false), time);
    const double high =
      begin[1] + displacement(BoxFace(direction, /*upper=*/true), time);
    const auto &stay = fixed[direction];
    const auto  between =
      [place](const double a, const double b, const double x, const double y) {
        return place == b ? y : x + (place - a) * ((y - x) / (b - a));
      };
    if (stay[0] > stay[1]) // no obstacle
      return between(begin[0], begin[1], low, high);
    if (place < stay[0])
      return between(begin[0], stay[0], low, stay[0]);
    if (place > stay[1])
      return between(stay[1], begin[1], stay[1], high);
    return place;
  }

  template <int dim>
  dealii::BoundingBox<dim>
  WallMotion<dim>::box(const double time) const
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] =
          sides[d][0] + displacement(BoxFace(d, /*upper=*/false), time);
        upper[d] = sides[d][1] + displacement(BoxFace(d, /*upper=*/true), time);
      }
    return dealii::BoundingBox<dim>({lower, upper});
  }

  template class WallMotion<2>;
  template class WallMotion<3>;
} // namespace seiche
