// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_tank_motion_h
#define seiche_scene_tank_motion_h

#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/rigid_motion.h>

#include <array>

namespace seiche
{
  /// prm entries of "Tank motion".
  template <int dim>
  struct TankMotionParameters : RigidMotionParameters<dim>
  {
    void
    add_parameters(dealii::ParameterHandler &prm);
  };

  /**
   * @brief Where the tank is at some time, and how it moves: X = c + d + R (x -
   * c) takes a place x of the tank to the laboratory, c the centre
   * (doc/theory.md (8.5), (8.6)).
   */
  template <int dim>
  struct TankPose
  {
    dealii::Tensor<1, dim>               displacement; ///< d [m]
    std::array<double, n_rotations<dim>> angles{}; ///< [rad], roll, pitch, yaw
    dealii::Tensor<2, dim>               rotation; ///< R [-]
    dealii::Tensor<1, dim>               acceleration; ///< R^T d'' [m/s^2]
    dealii::Tensor<2, dim>               of_place;     ///< R^T R'' [1/s^2]
    dealii::Tensor<2, dim>               coriolis;     ///< 2 R^T R' [1/s]
  };

  /**
   * @brief Motion of the tank, in whose frame a scene is computed
   * (doc/theory.md (8.5) to (8.7); Landau and Lifshitz, Mechanics, section 39).
   */
  template <int dim>
  class TankMotion
  {
  public:
    /// @p step: the largest of the run [s]. Throws InputError for what is no
    /// expression of t, jumps, or ends before @p end_time [s].
    TankMotion(const TankMotionParameters<dim> &parameters,
               const GridParameters<dim>       &grid,
               const InputFile                 &input,
               const double                     end_time,
               const double                     step);

    /// True if the tank moves.
    bool
    any() const
    {
      return motion.any();
    }

    /// The pose at a time of the run [s]; the last one asked for is kept.
    const TankPose<dim> &
    at(const double time) const;

    /// The motion in a direction of BodyDirection at a time of the run [s].
    MotionJet
    jet(const unsigned int direction, const double time) const
    {
      return motion.jet(direction, time);
    }

    /// [m]
    const dealii::Point<dim> &
    centre() const
    {
      return motion.centre;
    }

    /// What the fluid moves; null if there is only the motion that is given.
    const FreeBody<dim> *
    body() const
    {
      return motion.body();
    }

    const RigidMotion<dim> &
    free_motion() const
    {
      return motion;
    }

    /// To be moved: at() and jet() follow.
    RigidMotion<dim> &
    motion_to_move()
    {
      return motion;
    }

  private:
    RigidMotion<dim> motion;

    mutable double        time_of_pose;
    mutable unsigned int  version_of_body = 0;
    mutable TankPose<dim> pose;
  };
} // namespace seiche

#endif
