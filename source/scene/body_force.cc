// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/body_force.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  namespace
  {
    const char *const acceleration_path = "Body force/Acceleration";
  }



  template <int dim>
  void
  BodyForceParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Body force");
    prm.add_parameter("Acceleration",
                      acceleration,
                      "Acceleration of the fluid by gravity: one expression of "
                      "x, y[, z], t per direction, separated by \";\", as in "
                      "0; -9.81. With a \"Tank motion\" these are axes and "
                      "places of the laboratory. [m/s^2]");
    prm.leave_subsection();
  }



  template <int dim>
  void
  BodyForceParameters<dim>::check(const InputFile &input,
                                  const double     end_time) const
  {
    const Expression<dim> expression(input,
                                     acceleration_path,
                                     acceleration,
                                     dim);
    expression.check_until(end_time);
  }



  template <int dim>
  BodyForce<dim>::BodyForce(const BodyForceParameters<dim> &parameters,
                            const TankMotion<dim>          &tank_motion,
                            const InputFile                &input)
    : tank(tank_motion)
    , acceleration(input, acceleration_path, parameters.acceleration, dim)
  {
    if (acceleration.is_constant())
      constant = acceleration.vector_value(dealii::Point<dim>(), /*t=*/0.);
  }



  template <int dim>
  dealii::Tensor<1, dim>
  BodyForce<dim>::value(const dealii::Point<dim> &x, const double t) const
  {
    const auto in_laboratory = [&](const dealii::Point<dim> &X) {
      return acceleration.is_constant() ? constant :
                                          acceleration.vector_value(X, t);
    };
    if (!tank.any())
      return in_laboratory(x);
    const TankPose<dim>         &pose = tank.at(t);
    const dealii::Tensor<1, dim> r    = x - tank.centre();
    return transpose(pose.rotation) *
             in_laboratory(tank.centre() + pose.displacement +
                           pose.rotation * r) -
           pose.acceleration - pose.of_place * r;
  }



  template <int dim>
  bool
  BodyForce<dim>::is_constant() const
  {
    return acceleration.is_constant() && !tank.any();
  }



  template <int dim>
  const dealii::Tensor<1, dim> &
  BodyForce<dim>::constant_value() const
  {
    Assert(is_constant(),
           dealii::ExcMessage("The body force depends on place or time."));
    return constant;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  BodyForce<dim>::gravity(const double t) const
  {
    return tank.any() ? transpose(tank.at(t).rotation) * constant : constant;
  }



  template struct BodyForceParameters<2>;
  template struct BodyForceParameters<3>;
  template class BodyForce<2>;
  template class BodyForce<3>;
} // namespace seiche
