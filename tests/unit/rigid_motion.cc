// SPDX-License-Identifier: LGPL-2.1-or-later
// Ways and velocities of solids that move against the places of theirs.
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
} // namespace

int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
