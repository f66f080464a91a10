// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_materials_power_law_h
#define seiche_materials_power_law_h

#include <seiche/materials/viscosity_law.h>

namespace seiche
{
  /**
   * @brief mu = K (gamma^2 + gamma_0^2)^((n - 1)/2): shear-thinning for n < 1,
   * shear-thickening for n > 1 (Bird, Armstrong and Hassager 1987, section 4.1;
   * gamma_0 keeps mu and its derivative finite in fluid at rest).
   *
   * K [Pa s^n] is the entry "Dynamic viscosity", the viscosity at a shear rate
   * of 1/s.
   */
  class PowerLaw : public ViscosityLaw
  {
  public:
    /// @p n [-], @p gamma_0 [1/s].
    explicit PowerLaw(const double n = 1., const double gamma_0 = 1e-3)
      : ViscosityLaw(/*constant=*/false)
      , flow_index(n)
      , least_shear_rate(gamma_0)
    {}

    Viscosity
    at(const Lanes &gamma_square) const override;
    void
    add_parameters(dealii::ParameterHandler &prm) override;
    void
    check(const InputFile   &input,
          const std::string &section,
          const bool         chosen) const override;

  private:
    double flow_index, least_shear_rate;
  };
} // namespace seiche

#endif
