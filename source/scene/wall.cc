// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/wall.h>
#include <seiche/shapes/solid_shapes.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Part of the step over which a velocity is a difference.
    constexpr double difference = 1e-3;
  } // namespace

  template <int dim>
  void
  Wall<dim>::build(const InputFile &input)
  {
    if (is_side())
      {
        Tensor<1, dim> into_fluid;
        into_fluid[side().direction()] = -side().outward();
        shape = half_space_shape<dim>(lower_corner, into_fluid, box());
      }
    else
      shape = box_shape<dim>(box());
    if (!velocity_text.empty())
      sliding = std::make_shared<Expression<dim>>(
        input, path("velocity"), velocity_text, dim, box().center());
    if (!displacement_text.empty())
      way = std::make_shared<Expression<dim>>(input,
                                              path("displacement"),
                                              displacement_text,
                                              /*n_components=*/1,
                                              box().center());
  }

  template <int dim>
  void
  Wall<dim>::check(const InputFile        &input,
                   const BoundingBox<dim> &domain,
                   const double            end_time) const
  {
    if (slides())
      check_sliding(input, end_time);
    if (!is_displaced())
      return;
    const std::string entry = path("displacement");
    input.require(condition != WallCondition::open,
                  entry,
                  "an open side is no wall; only walls move.");
    const auto [lower, upper] = domain.get_boundary_points();
    way->check_motion(lower, upper, end_time);
    input.require(displacement(/*t=*/0.) == 0.,
                  entry,
                  "it must be 0 at t = 0: the wall begins where the grid has "
                  "its side.");
  }

  template <int dim>
  void
  Wall<dim>::check_sliding(const InputFile &input, const double end_time) const
  {
    const std::string entry = path("velocity");
    input.require(condition == WallCondition::no_slip,
                  entry,
                  "only a wall with the condition no-slip moves the fluid; set "
                  "it, or leave this entry empty.");
    sliding->check_until(end_time);
    if (!is_side())
      return;
    for (const double t : sample_times(end_time))
      input.require(
        sliding->vector_value(box().center(), t)[side().direction()] == 0.,
        entry,
        fmt::format("the wall moves along itself only: its normal component "
                    "must be 0, also at t = {:.4g} s.",
                    t));
  }

  template <int dim>
  Point<dim>
  Wall<dim>::at_start(Point<dim> x, const double t) const
  {
    if (is_displaced())
      x[side().direction()] -= displacement(t);
    return x;
  }

  template <int dim>
  double
  Wall<dim>::distance(const Point<dim> &x, const double t) const
  {
    return shape->distance(at_start(x, t));
  }

  template <int dim>
  Tensor<1, dim>
  Wall<dim>::normal(const Point<dim> &x, const double t) const
  {
    return shape->normal(at_start(x, t));
  }

  template <int dim>
  Tensor<1, dim>
  Wall<dim>::sliding_velocity(const Point<dim> &x, const double t) const
  {
    return sliding ? sliding->vector_value(x, t) : Tensor<1, dim>();
  }

  template <int dim>
  Tensor<1, dim>
  Wall<dim>::velocity(const Point<dim> &x,
                      const double      t,
                      const double      dt) const
  {
    Tensor<1, dim> result = sliding_velocity(x, t);
    if (way)
      {
        // one-sided, of second order: a motion need not be defined before t = 0
        const double h = difference * dt;
        result[side().direction()] =
          (-3. * displacement(t) + 4. * displacement(t + h) -
           displacement(t + 2. * h)) /
          (2. * h);
      }
    return result;
  }

  template struct Wall<2>;
  template struct Wall<3>;
} // namespace seiche
