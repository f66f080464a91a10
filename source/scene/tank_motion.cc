// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/jumps.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/tank_motion.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    const char *const displacement_path = "Tank motion/Displacement";
    const char *const rotation_path     = "Tank motion/Rotation";
    const char *const centre_path       = "Tank motion/Centre";

    /// Of the largest step: times between which derivatives are differences.
    constexpr double share_of_step = 0.25;

    /// Motion between two samples without a closer look for jumps: share of
    /// the tank, and angle [rad].
    constexpr double slow = 0.01;

    /// Derivatives by the polynomial of degree 4 through five values around a
    /// time, which all lie within the run: a motion need not be defined
    /// outside.
    template <typename Function>
    MotionJet
    differentiate(const Function &f,
                  const double    time,
                  const double    h,
                  const double    end_time)
    {
      const double c =
        std::clamp(time, 2. * h, std::max(end_time - 2. * h, 2. * h));
      const double                s = (time - c) / h;
      const std::array<double, 5> v = {
        {f(c - 2. * h), f(c - h), f(c), f(c + h), f(c + 2. * h)}};
      // h^k times the derivatives at c
      const double d1 = (v[0] - 8. * v[1] + 8. * v[3] - v[4]) / 12.,
                   d2 = (-v[0] + 16. * v[1] - 30. * v[2] + 16. * v[3] - v[4]) /
                        12.,
                   d3 = (-v[0] + 2. * v[1] - 2. * v[3] + v[4]) / 2.,
                   d4 = v[0] - 4. * v[1] + 6. * v[2] - 4. * v[3] + v[4];
      return {f(time),
              (d1 + s * (d2 + s * (d3 / 2. + s * d4 / 6.))) / h,
              (d2 + s * (d3 + s * d4 / 2.)) / (h * h)};
    }

    /// A matrix that depends on time and its first two derivatives.
    template <int dim>
    struct MatrixJet
    {
      Tensor<2, dim> value, first, second;
    };

    template <int dim>
    MatrixJet<dim>
    operator*(const MatrixJet<dim> &a, const MatrixJet<dim> &b)
    {
      return {a.value * b.value,
              a.first * b.value + a.value * b.first,
              a.second * b.value + 2. * (a.first * b.first) +
                a.value * b.second};
    }

    /// Turn by an angle about the axis (in 2D about z): I + sin E + (1 - cos)
    /// E^2 with E v = axis x v (Rodrigues).
    template <int dim>
    MatrixJet<dim>
    turn(const unsigned int axis, const MotionJet &angle)
    {
      const unsigned int i = dim == 2 ? 0 : (axis + 1) % dim,
                         j = dim == 2 ? 1 : (axis + 2) % dim;
      Tensor<2, dim> E;
      E[j][i]                     = 1.;
      E[i][j]                     = -1.;
      const Tensor<2, dim> square = E * E;
      const double         s = std::sin(angle.value), c = std::cos(angle.value);
      MatrixJet<dim>       result;
      // 1 - cos without cancellation
      result.value = unit_symmetric_tensor<dim>();
      result.value +=
        s * E + 2. * std::pow(std::sin(0.5 * angle.value), 2) * square;
      const Tensor<2, dim> slope     = c * E + s * square,
                           curvature = c * square - s * E;
      result.first                   = angle.first * slope;
      result.second =
        angle.second * slope + angle.first * angle.first * curvature;
      return result;
    }
  } // namespace

  template <int dim>
  void
  TankMotionParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Tank motion");
    prm.add_parameter(
      "Displacement",
      displacement,
      "Of the tank's Centre in the laboratory: one expression "
      "of t per direction, separated by \";\". The scene (grid, "
      "bodies, velocities, results) is that of the tank's "
      "frame, Body force that of the laboratory; empty: none. "
      "[m]",
      Patterns::Anything());
    prm.add_parameter(
      "Rotation",
      rotation,
      dim == 2 ? "Angle of the tank about its Centre, counterclockwise: "
                 "an expression of t; empty: none. [rad]" :
                 "Angles of the tank about its Centre: roll; pitch; yaw, "
                 "expressions of t. It is turned by the roll about x, "
                 "then by the pitch about y, then by the yaw about z, "
                 "axes of the laboratory; empty: none. [rad]",
      Patterns::Anything());
    prm.add_parameter("Centre",
                      centre,
                      "Point of the tank, also outside of it, about which it "
                      "turns. [m]",
                      Patterns::Anything());
    body.add_parameters(prm);
    prm.leave_subsection();
  }

  template <int dim>
  void
  TankMotionParameters<dim>::check(const InputFile &input) const
  {
    body.check(input);
    input.read_only_if(turns(),
                       centre_path,
                       "Tank motion/Rotation or a free angle");
    if constexpr (dim == 3)
      input.require(rotation.empty() || !body.turns(),
                    rotation_path,
                    "a tank that is free to turn has no other rotation in 3D: "
                    "axes would not stay; leave it empty.");
  }

  template <int dim>
  TankMotion<dim>::TankMotion(const TankMotionParameters<dim> &parameters,
                              const GridParameters<dim>       &grid,
                              const InputFile                 &input,
                              const double                     last_time,
                              const double                     step)
    : centre(entry_values::point<dim>(input, centre_path, parameters.centre))
    , end_time(last_time)
    , spacing(share_of_step * std::min(step, end_time))
    , time_of_pose(std::numeric_limits<double>::quiet_NaN())
  {
    if (parameters.body.any())
      free_body =
        std::make_unique<TankBody<dim>>(parameters.body, input, end_time);
    const Tensor<1, dim> edges = grid.upper_corner - grid.lower_corner;
    const double         smallest =
      *std::min_element(edges.begin_raw(), edges.end_raw());
    const auto read = [&](std::optional<Expression<dim>> &expression,
                          const char *const               path,
                          const std::string              &text,
                          const unsigned int              n_components,
                          const double                    slow_way) {
      if (text.empty())
        return;
      expression.emplace(input, path, text, n_components, grid.lower_corner);
      expression->check_motion(grid.lower_corner, grid.upper_corner, end_time);
      double before = 0.;
      for (const double t : sample_times(end_time))
        {
          for (unsigned int c = 0; c < n_components; ++c)
            input.require(
              !jumps(
                [&](const double time) {
                  return expression->value(centre, time, c);
                },
                before,
                t,
                slow_way),
              path,
              fmt::format("the tank jumps between t = {:.4g} s and "
                          "{:.4g} s; an expression without steps is "
                          "needed.",
                          before,
                          t));
          before = t;
        }
    };
    read(displacement,
         displacement_path,
         parameters.displacement,
         dim,
         slow * smallest);
    read(rotation, rotation_path, parameters.rotation, n_angles, slow);
  }

  template <int dim>
  MotionJet
  TankMotion<dim>::jet(const unsigned int direction, const double time) const
  {
    const bool  is_angle   = direction >= dim;
    const auto &expression = is_angle ? rotation : displacement;
    MotionJet   result;
    if (expression)
      result = differentiate(
        [&](const double t) {
          return expression->value(centre, t, direction - dim * is_angle);
        },
        time,
        spacing,
        end_time);
    if (free_body)
      {
        const MotionJet free = free_body->jet(direction, time);
        result.value += free.value;
        result.first += free.first;
        result.second += free.second;
      }
    return result;
  }

  template <int dim>
  const TankPose<dim> &
  TankMotion<dim>::at(const double time) const
  {
    if (time == time_of_pose &&
        (!free_body || version_of_body == free_body->version()))
      return pose;
    if (free_body)
      version_of_body = free_body->version();
    MatrixJet<dim> R;
    R.value = unit_symmetric_tensor<dim>();
    for (unsigned int a = 0; a < n_angles; ++a)
      {
        const MotionJet angle = jet(dim + a, time);
        pose.angles[a]        = angle.value;
        R                     = turn<dim>(a, angle) * R;
      }
    Tensor<1, dim> acceleration;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const MotionJet place = jet(d, time);
        pose.displacement[d]  = place.value;
        acceleration[d]       = place.second;
      }
    const Tensor<2, dim> back = transpose(R.value), turning = back * R.first;
    pose.rotation     = R.value;
    pose.acceleration = back * acceleration;
    pose.of_place     = back * R.second;
    pose.coriolis     = turning - transpose(turning); // does no work
    time_of_pose      = time;
    return pose;
  }

  template struct TankMotionParameters<2>;
  template struct TankMotionParameters<3>;
  template class TankMotion<2>;
  template class TankMotion<3>;
} // namespace seiche
