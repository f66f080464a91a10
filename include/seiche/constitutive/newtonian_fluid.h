// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_constitutive_newtonian_fluid_h
#define seiche_constitutive_newtonian_fluid_h

#include <cmath>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /**
   * @brief Material constants of the fluid (prm subsection "Fluid"); all are
   * mandatory.
   */
  struct FluidParameters
  {
    double      density           = 0.; ///< [kg/m^3] of the fluid at rest
    double      dynamic_viscosity = 0.; ///< [Pa s]
    double      bulk_modulus      = 0.; ///< [Pa], infinity if incompressible
    std::string volume_law        = "linear";

    void
    add_parameters(dealii::ParameterHandler &prm);

    bool
    is_incompressible() const
    {
      return std::isinf(bulk_modulus);
    }

    /// True if the pressure goes with ln J; J = 1 needs no law.
    bool
    has_logarithmic_volume() const
    {
      return !is_incompressible() && volume_law == "logarithmic";
    }

    /// Reads the bulk modulus; InputError for what makes no sense.
    void
    check(const InputFile &input);

  private:
    std::string bulk_modulus_text = "infinite";
  };
} // namespace seiche

#endif
