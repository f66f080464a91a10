// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_body_force_h
#define seiche_scene_body_force_h

#include <seiche/scene/tank_motion.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Body force".
  template <int dim>
  struct BodyForceParameters
  {
    std::string acceleration = (dim == 2 ? "0; 0" : "0; 0; 0"); // [m/s^2]

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Parses the expressions; InputError for what is no expression, or not
    /// defined up to @p end_time [s].
    void
    check(const InputFile &input, const double end_time) const;
  };

  /**
   * @brief Acceleration that acts on all of the fluid at rest in the tank:
   * gravity or expressions of position and time, in the tank's axes, less the
   * acceleration of the place itself in a tank that moves. What depends on the
   * velocity, the Coriolis acceleration, belongs to the inertia (doc/theory.md
   * (8.7)).
   */
  template <int dim>
  class BodyForce
  {
  public:
    /// @p tank_motion and @p input must outlive the object. Throws InputError.
    BodyForce(const BodyForceParameters<dim> &parameters,
              const TankMotion<dim>          &tank_motion,
              const InputFile                &input);

    /// Acceleration [m/s^2] at a place [m] and time [s]: R^T (g - d'') - R^T
    /// R'' (x - c), see TankPose; g that at the place in the laboratory.
    dealii::Tensor<1, dim>
    value(const dealii::Point<dim> &x, const double t) const;

    /// True if neither place nor time occurs.
    bool
    is_constant() const;

    /// The constant acceleration [m/s^2]; Assert if it is not constant.
    const dealii::Tensor<1, dim> &
    constant_value() const;

    /// Of a constant "Acceleration" what it is in the tank's axes [m/s^2], of
    /// any other one zero.
    dealii::Tensor<1, dim>
    gravity(const double t) const;

    const TankMotion<dim> &tank;

  private:
    Expression<dim>        acceleration; ///< in the laboratory
    dealii::Tensor<1, dim> constant;
  };
} // namespace seiche

#endif
