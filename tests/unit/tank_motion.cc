// SPDX-License-Identifier: LGPL-2.1-or-later
// The tank's frame against the laboratory: pose, accelerations, tables, and the
// refused motions.
#include <seiche/scene/body_force.h>

#include <deal.II/physics/transformations.h>

#include <cmath>
#include <fstream>

#include "scene_from_text.h"

namespace
{
  using namespace dealii;
  using namespace seiche;

  constexpr double end_time = 2., step = 0.01;

  template <int dim>
  TankMotionParameters<dim>
  swinging()
  {
    TankMotionParameters<dim> parameters;
    parameters.displacement =
      dim == 2 ? "0.3*sin(2*t); 0.1*t^2" : "0.3*sin(2*t); 0.1*t^2; 0.2*cos(t)";
    parameters.rotation =
      dim == 2 ? "0.7*t + 0.4*sin(3*t)" :
                 "0.7*t + 0.4*sin(3*t); 0.5*sin(2*t); 0.3*t^2 - 0.6*t";
    parameters.centre = dim == 2 ? "0.2, -0.1" : "0.2, -0.1, 0.3";
    return parameters;
  }

  /// A box with edges of 1 m.
  template <int dim>
  GridParameters<dim>
  box(const InputFile &input)
  {
    GridParameters<dim> grid(input);
    for (unsigned int d = 0; d < dim; ++d)
      grid.upper_corner[d] = 1.;
    return grid;
  }

  template <int dim>
  Point<dim>
  place(const double a, const double b, const double c)
  {
    Point<dim> x;
    x[0]       = a;
    x[1]       = b;
    x[dim - 1] = dim == 2 ? b : c;
    return x;
  }

  /// R by deal.II's rotations.
  template <int dim>
  Tensor<2, dim>
  rotation_of(const TankPose<dim> &pose)
  {
    using namespace Physics::Transformations::Rotations;
    if constexpr (dim == 2)
      return rotation_matrix_2d(pose.angles[0]);
    else
      {
        const auto turn = [&](const unsigned int axis) {
          Tensor<1, 3> direction;
          direction[axis] = 1.;
          return Tensor<2, 3>(
            rotation_matrix_3d(Point<3>(direction), pose.angles[axis]));
        };
        return turn(2) * turn(1) * turn(0);
      }
  }

  /// A particle x(t) in the tank, and what its acceleration in the laboratory
  /// is by differences: R^T A = a + coriolis v - (value of the body force
  /// without gravity).
  template <int dim>
  void
  compare_with_laboratory(const InputFile &input)
  {
    const TankMotion<dim> tank(
      swinging<dim>(), box<dim>(input), input, end_time, step);
    const BodyForce<dim>     inertial(BodyForceParameters<dim>(), tank, input);
    BodyForceParameters<dim> field;
    field.acceleration = dim == 2 ? "y; -9.81 + x*t" : "y; z; -9.81 + x*t";
    const BodyForce<dim> force(field, tank, input);

    const Tensor<1, dim> x0 = place<dim>(0.5, 0.3, -0.4),
                         v0 = place<dim>(-1., 0.8, 0.6),
                         a0 = place<dim>(2., -1.5, 0.9);
    double worst_pose = 0., worst_acceleration = 0., worst_work = 0.,
           worst_gravity = 0.;
    for (const double t : {0., 0.004, 0.731, 1.5, 1.998, 2.})
      {
        const auto in_tank = [&](const double time) {
          const double s = time - t;
          return Point<dim>(x0 + s * v0 + 0.5 * s * s * a0);
        };
        // of the formulas, which are there for all times
        const auto in_laboratory = [&](const double time) {
          TankPose<dim> pose;
          pose.angles[0] = 0.7 * time + 0.4 * std::sin(3. * time);
          if (dim == 3)
            {
              pose.angles[1 % pose.angles.size()] = 0.5 * std::sin(2. * time);
              pose.angles[2 % pose.angles.size()] =
                0.3 * time * time - 0.6 * time;
            }
          Tensor<1, dim> d = place<dim>(0.3 * std::sin(2. * time),
                                        0.1 * time * time,
                                        0.2 * std::cos(time));
          return Point<dim>(tank.centre() + d +
                            rotation_of(pose) *
                              (in_tank(time) - tank.centre()));
        };
        const double         h = 2e-3;
        const Tensor<1, dim> A =
          (16. * (in_laboratory(t + h) + Tensor<1, dim>(in_laboratory(t - h))) -
           (in_laboratory(t + 2. * h) +
            Tensor<1, dim>(in_laboratory(t - 2. * h))) -
           30. * Tensor<1, dim>(in_laboratory(t))) /
          (12. * h * h);

        const TankPose<dim> &pose = tank.at(t);
        const Point<dim>     X(tank.centre() + pose.displacement +
                           pose.rotation * (in_tank(t) - tank.centre()));
        worst_pose = std::max(worst_pose, X.distance(in_laboratory(t)));
        worst_pose =
          std::max(worst_pose, (pose.rotation - rotation_of(pose)).norm());
        const Tensor<1, dim> expected =
          a0 + pose.coriolis * v0 - inertial.value(in_tank(t), t);
        worst_acceleration =
          std::max(worst_acceleration,
                   (transpose(pose.rotation) * A - expected).norm());
        worst_work = std::max(worst_work, std::abs(v0 * (pose.coriolis * v0)));
        Tensor<1, dim> g;
        g[0]       = X[1];
        g[1]       = dim == 2 ? -9.81 + X[0] * t : X[dim - 1];
        g[dim - 1] = -9.81 + X[0] * t;
        worst_gravity =
          std::max(worst_gravity,
                   (force.value(in_tank(t), t) - inertial.value(in_tank(t), t) -
                    transpose(pose.rotation) * g)
                     .norm());
      }
    const auto verdict = [](const double error, const double limit) {
      return error < limit ? "yes" : "NO, " + std::to_string(error);
    };
    print(dim, "D");
    print("  pose: ", verdict(worst_pose, 1e-12));
    print("  acceleration of a particle (of up to 30 m/s^2) to 1e-5: ",
          verdict(worst_acceleration, 1e-5));
    print("  Coriolis acceleration works nothing: ",
          verdict(worst_work, 1e-13));
    print("  gravity of the laboratory, turned: ",
          verdict(worst_gravity, 1e-12));
    print("  constant: ", force.is_constant() ? "yes" : "no");
  }

  /// 4 degrees, period 1.63 s, in rows of 0.02 s.
  void
  write_table(const std::string &name, const double end)
  {
    std::ofstream table(name);
    table.precision(15);
    table << "t,angle in degrees\n";
    for (unsigned int i = 0; 0.02 * i < end + 1e-9; ++i)
      table << 0.02 * i << ','
            << 4. * std::sin(2. * numbers::PI * 0.02 * i / 1.63) << '\n';
  }

  InputFile
  with_table(const std::string &entries)
  {
    return InputFile(file_with("set Dimension = 2\nsubsection Table roll\n"
                               "  set File = roll.csv\n" +
                               entries + "end\n"),
                     {});
  }

  /// Angular accelerations of a table and of the formula, over the largest.
  void
  compare_with_table()
  {
    for (const char *interpolation : {"cubic spline", "akima"})
      {
        const InputFile input =
          with_table(std::string("  set Factors = 1, 0.017453292519943295\n"
                                 "  set Interpolation = ") +
                     interpolation + "\n");
        TankMotionParameters<2> table, formula;
        table.rotation   = "roll(t)";
        formula.rotation = "4*pi/180*sin(2*pi*t/1.63)";
        const TankMotion<2> one(table, box<2>(input), input, end_time, step);
        const TankMotion<2> other(
          formula, box<2>(input), input, end_time, step);
        double angle = 0., acceleration = 0.;
        for (double t = 0.1; t < 1.9; t += 0.0037)
          {
            angle =
              std::max(angle,
                       std::abs(one.at(t).angles[0] - other.at(t).angles[0]) /
                         0.0698);
            acceleration = std::max(acceleration,
                                    std::abs(one.at(t).of_place[1][0] -
                                             other.at(t).of_place[1][0]) /
                                      1.037);
          }
        print("table, ",
              interpolation,
              ": angle to 1e-5: ",
              angle < 1e-5 ? "yes" : "no",
              ", acceleration to 1 %: ",
              acceleration < 1e-2 ? "yes" : "no");
      }
  }

  void
  refuse(const InputFile   &input,
         const std::string &rotation,
         const std::string &displacement = "")
  {
    TankMotionParameters<2> parameters;
    parameters.rotation     = rotation;
    parameters.displacement = displacement;
    print_input_error([&]() {
      const TankMotion<2> tank(
        parameters, box<2>(input), input, end_time, step);
    });
  }
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  write_table("roll.csv", 2.);
  const InputFile input(file_with("set Dimension = 2\n"), {});
  compare_with_laboratory<2>(input);
  compare_with_laboratory<3>(input);
  compare_with_table();

  refuse(input, "x*t");
  refuse(input, "0.1*t; 0");
  refuse(input, "t < 1 ? 0 : 0.1");
  refuse(input, "", "0.1*t");
  refuse(input, "1/(t - 1)");
  refuse(with_table("  set Interpolation = linear\n"), "roll(t)");
  write_table("roll.csv", 1.5);
  refuse(with_table(""), "roll(t)");
  refuse(with_table(""), "roll(t - 1)");
}
