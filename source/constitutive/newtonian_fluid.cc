// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/constitutive/newtonian_fluid.h>
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <limits>

namespace seiche
{
  namespace
  {
    /// No fluid has more, and products of what is far above are no numbers any
    /// more [kg/m^3], [Pa s], [Pa].
    constexpr double largest_density = 1e20, largest_viscosity = 1e30,
                     largest_modulus = 1e30;
  } // namespace



  void
  FluidParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Fluid");
    prm.add_parameter("Density",
                      density,
                      "Density of the fluid at rest, greater than zero. "
                      "[kg/m^3]",
                      dealii::Patterns::Double(0., largest_density),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Dynamic viscosity",
                      dynamic_viscosity,
                      "Dynamic viscosity; 0 for an inviscid fluid. [Pa s]",
                      dealii::Patterns::Double(0., largest_viscosity),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Bulk modulus",
                      bulk_modulus_text,
                      "Bulk modulus: a positive number, or \"infinite\" for "
                      "an incompressible fluid (mixed form only). [Pa]",
                      dealii::Patterns::Anything(),
                      /*has_to_be_set=*/true);
    prm.add_parameter(
      "Volume law",
      volume_law,
      "Pressure of a finite bulk modulus kappa. linear: "
      "kappa (1 - J); logarithmic: -kappa ln J. J is the ratio of "
      "volume to initial volume.",
      dealii::Patterns::Selection("linear|logarithmic"));
    prm.leave_subsection();
  }



  void
  FluidParameters::check(const InputFile &input)
  {
    input.read_only_if(bulk_modulus_text != "infinite",
                       "Fluid/Volume law",
                       "a finite Fluid/Bulk modulus");
    input.require(density > 0.,
                  "Fluid/Density",
                  "must be greater than zero [kg/m^3]; water has 1000.");
    if (bulk_modulus_text == "infinite")
      {
        bulk_modulus = std::numeric_limits<double>::infinity();
        return;
      }
    const std::string path = "Fluid/Bulk modulus";
    input.require(bulk_modulus_text.find_first_of("0123456789") !=
                    std::string::npos,
                  path,
                  "allowed are a positive number [Pa] and \"infinite\".");
    bulk_modulus = entry_values::number(input, path, bulk_modulus_text);
    input.require(bulk_modulus > 0. && bulk_modulus <= largest_modulus,
                  path,
                  "must be greater than zero and at most 1e30 [Pa], or "
                  "\"infinite\".");
  }
} // namespace seiche
