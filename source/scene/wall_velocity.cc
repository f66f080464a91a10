// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/wall_velocity.h>

#include <fmt/format.h>

namespace seiche
{
  template <int dim>
  WallVelocity<dim>::WallVelocity(const GridParameters<dim> &parameters,
                                  const InputFile           &input,
                                  const double               end_time)
  {
    expressions.resize(parameters.walls.size());
    for (unsigned int id = 0; id < expressions.size(); ++id)
      {
        const Wall<dim> &wall = parameters.walls[id];
        if (wall.velocity.empty())
          continue;
        const std::string path = wall.path("velocity");
        input.require(wall.condition == WallCondition::no_slip,
                      path,
                      "only a wall with the condition no-slip moves the fluid; "
                      "set it, or leave this entry empty.");
        const dealii::Point<dim> centre =
          wall.lower_corner + 0.5 * (wall.upper_corner - wall.lower_corner);
        expressions[id].emplace(input, path, wall.velocity, dim, centre);
        expressions[id]->check_until(end_time);
        if (!wall.is_side())
          continue;
        for (const double t : sample_times(end_time))
          input.require(value(id, centre, t)[wall.side().direction()] == 0.,
                        path,
                        fmt::format("the wall moves along itself only: its "
                                    "normal component must be 0, also at "
                                    "t = {:.4g} s.",
                                    t));
      }
  }



  template <int dim>
  bool
  WallVelocity<dim>::any() const
  {
    return std::any_of(expressions.begin(),
                       expressions.end(),
                       [](const auto &e) { return e.has_value(); });
  }



  template <int dim>
  dealii::Tensor<1, dim>
  WallVelocity<dim>::value(const unsigned int        wall,
                           const dealii::Point<dim> &x,
                           const double              t) const
  {
    return expressions[wall] ? expressions[wall]->vector_value(x, t) :
                               dealii::Tensor<1, dim>();
  }



  template class WallVelocity<2>;
  template class WallVelocity<3>;
} // namespace seiche
