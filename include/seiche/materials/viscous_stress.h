// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_viscous_stress_h
#define seiche_materials_viscous_stress_h

#include <seiche/materials/viscosity_law.h>

#include <deal.II/base/tensor.h>

namespace seiche
{
  /// e = 2 dev(sym(l)) at one or several points, l the velocity gradient; dev
  /// with 1/3 in 2D too (plane strain).
  template <int dim, typename Number>
  dealii::Tensor<2, dim, Number>
  shear_rate(const dealii::Tensor<2, dim, Number> &velocity_gradient)
  {
    const Number mean = dealii::trace(velocity_gradient) * (2. / 3.);
    dealii::Tensor<2, dim, Number> e;
    for (unsigned int i = 0; i < dim; ++i)
      {
        for (unsigned int j = 0; j < dim; ++j)
          e[i][j] = velocity_gradient[i][j] + velocity_gradient[j][i];
        e[i][i] -= mean;
      }
    return e;
  }

  /// gamma^2 = e:e/2 [1/s^2], with the e_zz of plane strain in 2D.
  template <int dim, typename Number>
  Number
  gamma_square(const dealii::Tensor<2, dim, Number> &e)
  {
    const Number trace  = dealii::trace(e);
    Number       square = dim == 2 ? trace * trace : Number(0.);
    for (unsigned int i = 0; i < dim; ++i)
      square += e[i] * e[i];
    return 0.5 * square;
  }

  /**
   * @brief The deviatoric stress s = mu e at several points, and its
   * derivative ds = mu de + 2 mu' (e:dl) e, mu' = dmu/d(gamma^2);
   * doc/theory.md (2.1a).
   */
  template <int dim>
  struct ViscousStress
  {
    dealii::Tensor<2, dim, Lanes> e; ///< [1/s]
    Viscosity                     mu;

    /// False if the derivative is ds = mu de.
    bool has_slope = false;

    void
    evaluate(const ViscosityLaw                  &law,
             const dealii::Tensor<2, dim, Lanes> &velocity_gradient)
    {
      e = shear_rate(velocity_gradient);
      if (law.is_constant)
        {
          mu.value = law.scale;
          return;
        }
      mu        = law.at(gamma_square(e));
      has_slope = true;
    }

    /// s [Pa], symmetric.
    dealii::Tensor<2, dim, Lanes>
    stress() const
    {
      return mu.value * e;
    }
  };
} // namespace seiche

#endif
