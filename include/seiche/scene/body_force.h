// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_body_force_h
#define seiche_scene_body_force_h

#include <seiche/scene/expression.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

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

    /// Parses the expressions; InputError for what is no expression.
    void
    check(const InputFile &input) const;
  };

  /**
   * @brief Acceleration that acts on all of the fluid: gravity or expressions
   * of position and time.
   */
  template <int dim>
  class BodyForce
  {
  public:
    /// @p input must outlive the object. Throws InputError.
    BodyForce(const BodyForceParameters<dim> &parameters,
              const InputFile                &input);

    /// Acceleration [m/s^2] at a place [m] and time [s].
    dealii::Tensor<1, dim>
    value(const dealii::Point<dim> &x, const double t) const;

    /// True if neither place nor time occurs.
    bool
    is_constant() const;

    /// The constant acceleration [m/s^2]; Assert if it is not constant.
    const dealii::Tensor<1, dim> &
    constant_value() const;

  private:
    Expression<dim>        acceleration;
    dealii::Tensor<1, dim> constant;
  };
} // namespace seiche

#endif
