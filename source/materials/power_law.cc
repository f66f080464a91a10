// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/materials/power_law.h>
#include <seiche/parameters/input_file.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace seiche
{
  Viscosity
  PowerLaw::at(const Lanes &gamma_square) const
  {
    const double exponent = 0.5 * (flow_index - 1.);
    const Lanes  base     = gamma_square + least_shear_rate * least_shear_rate;
    const Lanes  value = scale * std::experimental::pow(base, Lanes(exponent));
    return {value, exponent * value / base};
  }



  void
  PowerLaw::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Flow index",
                      flow_index,
                      "Of the power law, n: below 1 the fluid thins with the "
                      "shear rate, above it thickens [-]",
                      dealii::Patterns::Double(0.05, 5.));
    prm.add_parameter("Least shear rate",
                      least_shear_rate,
                      "Of the power law, gamma_0: well below it the viscosity "
                      "is that of gamma_0 [1/s]",
                      dealii::Patterns::Double(1e-12));
  }



  void
  PowerLaw::check(const InputFile   &input,
                  const std::string &section,
                  const bool         chosen) const
  {
    for (const char *entry : {"/Flow index", "/Least shear rate"})
      input.read_only_if(chosen,
                         section + entry,
                         section + "/Viscosity law = power law");
  }
} // namespace seiche
