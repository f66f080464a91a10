// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/tank_motion.h>

#include <deal.II/base/parameter_handler.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    const std::string section = "Tank motion";
  } // namespace

  template <int dim>
  void
  TankMotionParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    RigidMotionParameters<dim>::add_parameters(
      prm,
      "Of the tank's Centre in the laboratory: one expression "
      "of t per direction, separated by \";\". The scene (grid, "
      "bodies, velocities, results) is that of the tank's "
      "frame, Body force that of the laboratory; empty: none. "
      "[m]");
    prm.leave_subsection();
  }

  template <int dim>
  TankMotion<dim>::TankMotion(const TankMotionParameters<dim> &parameters,
                              const GridParameters<dim>       &grid,
                              const InputFile                 &input,
                              const double                     last_time,
                              const double                     step)
    : motion(parameters, input, grid.domain(), last_time, step)
    , time_of_pose(std::numeric_limits<double>::quiet_NaN())
  {}

  template <int dim>
  const TankPose<dim> &
  TankMotion<dim>::at(const double time) const
  {
    if (time == time_of_pose &&
        (!body() || version_of_body == body()->version()))
      return pose;
    if (body())
      version_of_body = body()->version();
    std::array<MotionJet, n_rotations<dim>> angles;
    for (unsigned int a = 0; a < angles.size(); ++a)
      {
        angles[a]      = jet(dim + a, time);
        pose.angles[a] = angles[a].value;
      }
    const MatrixJet<dim> R = rotation_jet<dim>(angles);
    Tensor<1, dim>       acceleration;
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
