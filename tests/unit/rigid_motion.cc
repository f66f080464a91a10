// SPDX-License-Identifier: LGPL-2.1-or-later
// Ways and velocities of solids that move against the places of theirs; a body
// that tumbles without moments against Euler's equations.
#include <seiche/scene/rigid_motion.h>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;
  using namespace seiche;

  constexpr double end_time = 2., step = 0.01;

  template <int dim>
  RigidMotionParameters<dim>
  swinging()
  {
    RigidMotionParameters<dim> parameters;
    parameters.displacement =
      dim == 2 ? "0.3*sin(2*t); 0.1*t^2" : "0.3*sin(2*t); 0.1*t^2; 0.2*cos(t)";
    parameters.rotation =
      dim == 2 ? "0.7*t + 0.4*sin(3*t)" :
                 "0.7*t + 0.4*sin(3*t); 0.5*sin(2*t); 0.3*t^2 - 0.6*t";
    parameters.centre = dim == 2 ? "0.2, -0.1" : "0.2, -0.1, 0.3";
    return parameters;
  }

  template <int dim>
  void
  test()
  {
    const InputFile input(file_with("set Dimension = 2\n"), {});
    Point<dim>      lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      upper[d] = 1.;
    const RigidMotion<dim> motion(
      swinging<dim>(), input, BoundingBox<dim>({lower, upper}), end_time, step);
    double worst_way = 0., worst_velocity = 0.;
    for (const double t : {0.01, 0.5, 1.2})
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Point<dim>     x     = 0.7 * Point<dim>::unit_vector(d);
          const Placement<dim> start = motion.at(t);
          for (const double theta : {0., 0.5, 1.})
            for (const double dt : {0.02, 0.4})
              {
                const Placement<dim> end  = motion.at(t + dt);
                const Tensor<1, dim> gone = end.place(x) - start.place(x);
                const Point<dim>     y    = start.place(x) + theta * gone;
                worst_way                 = std::max(
                  worst_way,
                  (way_between(start, end, theta).at(y) - gone).norm());
              }
          const double         h = 1e-4;
          const Tensor<1, dim> velocity =
            (motion.at(t + h).place(x) - motion.at(t - h).place(x)) / (2. * h);
          worst_velocity =
            std::max(worst_velocity,
                     (motion.velocity(t).at(start.place(x)) - velocity).norm());
        }
    const auto verdict = [](const double error, const double limit) {
      return error < limit ? "yes" : "NO, " + std::to_string(error);
    };
    print(dim, "D");
    print("  way of a step, also of turns by half a radian: ",
          verdict(worst_way, 1e-13));
    print("  velocity: ", verdict(worst_velocity, 1e-6));
  }

  /// Inertias about the axes of the body, the rates it starts with.
  constexpr std::array<double, 3> J = {{1., 2., 3.}}, w0 = {{0.1, 1.5, 0.2}};

  /// Rates about the body's own axes at the end, by Euler's equations
  /// J w' = J w x w and the classical Runge-Kutta scheme.
  Tensor<1, 3>
  rates_by_euler()
  {
    const auto slope = [](const Tensor<1, 3> &w) {
      Tensor<1, 3> result;
      for (unsigned int i = 0; i < 3; ++i)
        {
          const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
          result[i] = (J[j] - J[k]) / J[i] * w[j] * w[k];
        }
      return result;
    };
    constexpr unsigned int n = 4000;
    const double           h = end_time / n;
    Tensor<1, 3>           w;
    for (unsigned int i = 0; i < 3; ++i)
      w[i] = w0[i];
    for (unsigned int k = 0; k < n; ++k)
      {
        const Tensor<1, 3> a = slope(w), b = slope(w + 0.5 * h * a),
                           c = slope(w + 0.5 * h * b), d = slope(w + h * c);
        w += h / 6. * (a + 2. * b + 2. * c + d);
      }
    return w;
  }

  struct Tumbled
  {
    double rates;    ///< error of the rates about the body's axes
    double momentum; ///< that is lost
  };

  Tumbled
  tumble(const unsigned int n_steps)
  {
    const InputFile       input(file_with("set Dimension = 3\n"), {});
    FreeBodyParameters<3> parameters;
    parameters.may_tumble = true;
    parameters.free       = "roll, pitch, yaw";
    parameters.inertia    = "1; 2; 3";
    parameters.start_rate = "0.1, 1.5, 0.2";
    FreeBody<3>  body(parameters, input, end_time);
    const double dt = end_time / n_steps;
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        body.begin(k * dt, dt);
        for (unsigned int i = 0; i < 150; ++i) // a contraction by 2/3
          {
            const auto rate = body.angular_momentum_rate();
            for (unsigned int a = 0; a < 3; ++a)
              body.set_acceleration(a,
                                    body.freedoms()[a].acceleration -
                                      rate[a] / J[2]);
          }
        body.accept();
      }
    Tensor<1, 3> w, lost;
    for (unsigned int a = 0; a < 3; ++a)
      w[a] = body.freedoms()[a].rate;
    const Tensor<2, 3> &R       = body.orientation();
    const Tensor<1, 3>  of_body = transpose(R) * w;
    Tensor<1, 3>        L;
    for (unsigned int a = 0; a < 3; ++a)
      L[a] = J[a] * of_body[a];
    L = R * L;
    for (unsigned int a = 0; a < 3; ++a)
      lost[a] = L[a] - J[a] * w0[a];
    return {(of_body - rates_by_euler()).norm(), lost.norm()};
  }

  void
  test_tumbling()
  {
    const Tumbled coarse = tumble(50), fine = tumble(100);
    const double  order = std::log2(coarse.rates / fine.rates);
    print("a body that tumbles");
    print("  keeps its angular momentum: ",
          fine.momentum < 1e-10 ? "yes" :
                                  "NO, " + std::to_string(fine.momentum));
    print("  rates, 100 steps: ",
          fine.rates < 2e-3 ? "right" : "WRONG, " + std::to_string(fine.rates));
    print("  order: ",
          order > 1.9 && order < 2.5 ? "2" : "WRONG, " + std::to_string(order));
    const std::array<MotionJet, 3> turns = {
      {{0.7, 0., 0.}, {-1.2, 0., 0.}, {2.9, 0., 0.}}};
    const auto angles = angles_of<3>(rotation_jet<3>(turns).value);
    double     worst  = 0.;
    for (unsigned int a = 0; a < 3; ++a)
      worst = std::max(worst, std::abs(angles[a] - turns[a].value));
    print("  angles of a rotation: ", worst < 1e-12 ? "right" : "WRONG");
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  test_tumbling();
}
