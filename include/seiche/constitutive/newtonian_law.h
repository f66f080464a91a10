// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_constitutive_newtonian_law_h
#define seiche_constitutive_newtonian_law_h

#include <deal.II/base/tensor.h>

namespace seiche
{
  /**
   * @brief Deviatoric stress of an incompressible Newtonian fluid.
   *
   * s = 2 mu dev(sym(l)), dev with 1/3 in 2D too (plane strain). The weak
   * forms use the isotropic derivative ds = 2 mu_t dev(sym(dl)); a law whose
   * derivative has another shape needs a second method here and its term in
   * the formulations.
   */
  struct NewtonianLaw
  {
    double dynamic_viscosity = 0.; ///< [Pa s]

    bool
    is_inviscid() const
    {
      return dynamic_viscosity == 0.;
    }

    /// s [Pa], symmetric, from the velocity gradient l [1/s].
    template <int dim, typename Number>
    dealii::Tensor<2, dim, Number>
    stress(const dealii::Tensor<2, dim, Number> &velocity_gradient) const
    {
      const Number mean = dealii::trace(velocity_gradient) * (1. / 3.);
      dealii::Tensor<2, dim, Number> s;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          {
            s[i][j] = velocity_gradient[i][j] + velocity_gradient[j][i];
            if (i == j)
              s[i][j] -= 2. * mean;
            s[i][j] *= dynamic_viscosity;
          }
      return s;
    }

    /// mu_t [Pa s] of the derivative ds = 2 mu_t dev(sym(dl)).
    double
    tangent_viscosity() const
    {
      return dynamic_viscosity;
    }
  };
} // namespace seiche

#endif
