// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_step_balance_h
#define seiche_solve_step_balance_h

#include <deal.II/base/tensor.h>

namespace seiche
{
  /**
   * @brief Momentum and work of a converged step, summed over its quadrature:
   * inertia = body + walls, which is doc/theory.md (4.1) or (4.2) for constant
   * w (body force and inertia in a tank that moves: (8.7)).
   */
  template <int dim>
  struct StepBalance
  {
    dealii::Tensor<1, dim> inertia; ///< sum m a, relative to the tank [N]
    /// Of the body force and, in a tank that turns, the Coriolis force [N].
    dealii::Tensor<1, dim> body;
    dealii::Tensor<1, dim> walls;          ///< reactions on the fluid [N]
    double                 body_work = 0.; ///< of body in the step [J]
    dealii::Tensor<1, dim> mass_moment;    ///< sum m u [kg m]

    /// What is left of the balance [N].
    dealii::Tensor<1, dim>
    imbalance() const
    {
      return inertia - body - walls;
    }
  };
} // namespace seiche

#endif
