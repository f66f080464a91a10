// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/jumps.h>
#include <seiche/scene/rigid_motion.h>
#include <seiche/scene/sample_times.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of the largest step: times between which derivatives are differences.
    constexpr double share_of_step = 0.25;

    /// Motion between two samples without a closer look for jumps: share of
    /// the domain, and angle [rad].
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
  } // namespace

  template <int dim>
  void
  RigidMotionParameters<dim>::add_parameters(ParameterHandler  &prm,
                                             const std::string &of_displacement)
  {
    const std::string &what = body.what;
    prm.add_parameter(names.displacement,
                      displacement,
                      of_displacement,
                      Patterns::Anything());
    prm.add_parameter(names.rotation,
                      rotation,
                      dim == 2 ?
                        "Angle of the " + what + " about its " + names.centre +
                          ", counterclockwise: "
                          "an expression of t; empty: none. [rad]" :
                        "Angles of the " + what + " about its " + names.centre +
                          ": roll; pitch; yaw, "
                          "expressions of t. It is turned by the roll about x, "
                          "then by the pitch about y, then by the yaw about z, "
                          "axes of the laboratory; empty: none. [rad]",
                      Patterns::Anything());
    prm.add_parameter(names.centre,
                      centre,
                      "Point of the " + what +
                        ", also outside of it, about which it turns. [m]",
                      Patterns::Anything());
    body.add_parameters(prm);
  }

  template <int dim>
  void
  RigidMotionParameters<dim>::check(const InputFile &input) const
  {
    body.check(input);
    input.read_only_if(turns(),
                       body.path(names.centre),
                       body.path(names.rotation) + " or a free angle");
    if constexpr (dim == 3)
      input.require(rotation.empty() || !body.turns(),
                    body.path(names.rotation),
                    "a " + body.what +
                      " that is free to turn has no other rotation in 3D: "
                      "axes would not stay; leave it empty.");
  }

  template <int dim>
  RigidMotion<dim>::RigidMotion(const RigidMotionParameters<dim> &parameters,
                                const InputFile                  &input,
                                const BoundingBox<dim>           &domain,
                                const double                      last_time,
                                const double                      step)
    : centre(
        entry_values::point<dim>(input,
                                 parameters.body.path(parameters.names.centre),
                                 parameters.centre))
    , end_time(last_time)
    , spacing(share_of_step * std::min(step, end_time))
  {
    const auto [lower, upper] = domain.get_boundary_points();
    double smallest           = domain.side_length(0);
    for (unsigned int d = 1; d < dim; ++d)
      smallest = std::min(smallest, domain.side_length(d));
    const auto read =
      [&, lower = lower, upper = upper](std::optional<Expression<dim>> &motion,
                                        const std::string              &path,
                                        const std::string              &text,
                                        const unsigned int n_components,
                                        const double       slow_way) {
        if (text.empty())
          return;
        motion.emplace(input, path, text, n_components, lower);
        motion->check_motion(lower, upper, end_time);
        double before = 0.;
        for (const double t : sample_times(end_time))
          {
            for (unsigned int c = 0; c < n_components; ++c)
              input.require(
                !jumps(
                  [&](const double time) {
                    return motion->value(centre, time, c);
                  },
                  before,
                  t,
                  slow_way),
                path,
                fmt::format("it jumps between t = {:.4g} s and {:.4g} s; an "
                            "expression without steps is needed.",
                            before,
                            t));
            before = t;
          }
      };
    read(displacement,
         parameters.body.path(parameters.names.displacement),
         parameters.displacement,
         dim,
         slow * smallest);
    read(rotation,
         parameters.body.path(parameters.names.rotation),
         parameters.rotation,
         n_rotations<dim>,
         slow);
    if (parameters.body.any())
      free_body =
        std::make_unique<FreeBody<dim>>(parameters.body, input, end_time);
  }

  template <int dim>
  const Expression<dim> *
  RigidMotion<dim>::expression(const unsigned int direction) const
  {
    const auto &motion = direction >= dim ? rotation : displacement;
    return motion ? &*motion : nullptr;
  }

  template <int dim>
  MotionJet
  RigidMotion<dim>::jet(const unsigned int direction, const double time) const
  {
    MotionJet result;
    if (const Expression<dim> *motion = expression(direction))
      result = differentiate(
        [&](const double t) {
          return motion->value(centre, t, direction - dim * (direction >= dim));
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
  MatrixJet<dim>
  RigidMotion<dim>::rotation_at(const double time) const
  {
    std::array<MotionJet, n_rotations<dim>> angles;
    for (unsigned int a = 0; a < angles.size(); ++a)
      angles[a] = jet(dim + a, time);
    MatrixJet<dim> R = rotation_jet<dim>(angles);
    if (free_body && free_body->tumbles())
      for (Tensor<2, dim> *matrix : {&R.value, &R.first, &R.second})
        *matrix = *matrix * free_body->orientation();
    return R;
  }

  template <int dim>
  double
  RigidMotion<dim>::place(const unsigned int direction, const double time) const
  {
    return direction >= dim && free_body && free_body->tumbles() ?
             angles_of<dim>(rotation_at(time).value)[direction - dim] :
             jet(direction, time).value;
  }

  template <int dim>
  double
  RigidMotion<dim>::momentum_rate(const unsigned int freedom,
                                  const double       middle) const
  {
    const BodyDirection<dim> direction =
      free_body->freedoms()[freedom].direction;
    return direction.is_angle() && free_body->tumbles() ?
             free_body->angular_momentum_rate()[direction.number - dim] :
             free_body->inertia(freedom) * jet(direction.number, middle).second;
  }

  template <int dim>
  Placement<dim>
  RigidMotion<dim>::at(const double time) const
  {
    Placement<dim> result;
    result.rotation = rotation_at(time).value;
    result.pivot    = centre;
    for (unsigned int d = 0; d < dim; ++d)
      result.shift[d] = jet(d, time).value;
    return result;
  }

  template <int dim>
  RigidWay<dim>
  RigidMotion<dim>::velocity(const double time) const
  {
    const MatrixJet<dim> R = rotation_at(time);
    RigidWay<dim>        result;
    result.turn = R.first * transpose(R.value);
    Tensor<1, dim> place(centre);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const MotionJet way = jet(d, time);
        place[d] += way.value;
        result.shift[d] = way.first;
      }
    result.shift -= result.turn * place;
    return result;
  }

  template <int dim>
  RigidWay<dim>
  way_between(const Placement<dim> &start,
              const Placement<dim> &end,
              const double          theta)
  {
    const Tensor<2, dim> mean =
      (1. - theta) * start.rotation + theta * end.rotation;
    const Point<dim>     origin;
    const Tensor<1, dim> first = start.place(origin) - origin,
                         last  = end.place(origin) - origin;
    RigidWay<dim> result;
    result.turn = (end.rotation - start.rotation) * invert(mean);
    result.shift =
      last - first - result.turn * ((1. - theta) * first + theta * last);
    return result;
  }

#define INSTANTIATE(dim)                                     \
  template struct RigidMotionParameters<dim>;                \
  template class RigidMotion<dim>;                           \
  template RigidWay<dim> way_between(const Placement<dim> &, \
                                     const Placement<dim> &, \
                                     const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
