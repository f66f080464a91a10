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
    expressions.resize(parameters.n_walls());
    for (unsigned int wall = 0; wall < expressions.size(); ++wall)
      {
        const std::string text = parameters.wall_velocity_text(wall);
        if (text.empty())
          continue;
        const std::string path    = parameters.wall_velocity_path(wall);
        const bool        is_side = wall < 2 * dim;
        input.require(parameters.wall_condition(wall) == WallCondition::no_slip,
                      path,
                      "only a wall with the condition no-slip moves the fluid; "
                      "set it, or leave this entry empty.");
        auto box =
          is_side ?
            parameters.domain().get_boundary_points() :
            std::make_pair(parameters.obstacles[wall - 2 * dim].lower_corner,
                           parameters.obstacles[wall - 2 * dim].upper_corner);
        dealii::Point<dim> centre = box.first + 0.5 * (box.second - box.first);
        if (is_side)
          centre[wall / 2] =
            wall % 2 == 0 ? box.first[wall / 2] : box.second[wall / 2];
        expressions[wall].emplace(input, path, text, dim, centre);
        expressions[wall]->check_until(end_time);
        if (!is_side)
          continue;
        for (const double t : sample_times(end_time))
          input.require(value(wall, centre, t)[wall / 2] == 0.,
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
