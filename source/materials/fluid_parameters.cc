// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/materials/fluid_parameters.h>
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
  MaterialParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(section());
    prm.add_parameter("Density",
                      density,
                      "Density of the fluid at rest, greater than zero. "
                      "[kg/m^3]",
                      dealii::Patterns::Double(0., largest_density),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Dynamic viscosity",
                      dynamic_viscosity,
                      "Dynamic viscosity; 0 for an inviscid fluid. Of the "
                      "power law its K: the viscosity at a shear rate of 1/s. "
                      "[Pa s]",
                      dealii::Patterns::Double(0., largest_viscosity),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Viscosity law",
                      law_name,
                      "How the viscosity depends on the shear rate. " +
                        viscosity_law_descriptions(),
                      dealii::Patterns::Selection(viscosity_law_names()));
    for (NamedViscosityLaw &entry : laws)
      entry.law->add_parameters(prm);
    prm.leave_subsection();
  }



  void
  MaterialParameters::check(const InputFile &input)
  {
    input.require(density > 0.,
                  section() + "/Density",
                  "must be greater than zero [kg/m^3]; water has 1000.");
    for (NamedViscosityLaw &entry : laws)
      {
        const bool is_chosen = entry.name == law_name;
        entry.law->scale     = dynamic_viscosity;
        entry.law->check(input, section(), is_chosen);
        if (!is_chosen)
          continue;
        chosen = {name, density, entry.law};
        if (!entry.papers.empty())
          input.cites(entry.papers);
      }
  }



  void
  FluidParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    material.add_parameters(prm);
    prm.enter_subsection("Fluid");
    prm.add_parameter("Bulk modulus",
                      bulk_modulus_text,
                      "Bulk modulus: a positive number, or \"infinite\" for "
                      "an incompressible fluid (mixed form only). [Pa]",
                      dealii::Patterns::Anything(),
                      /*has_to_be_set=*/true);
    prm.add_parameter(
      "Volume law",
      volume_law_name,
      "Pressure of a finite bulk modulus kappa. linear: "
      "kappa (1 - J); logarithmic: -kappa ln J. J is the ratio of "
      "volume to initial volume.",
      dealii::Patterns::Selection("linear|logarithmic"));
    prm.leave_subsection();
  }



  void
  FluidParameters::check(const InputFile &input)
  {
    const bool is_infinite = bulk_modulus_text == "infinite";
    input.read_only_if(!is_infinite,
                       "Fluid/Volume law",
                       "a finite Fluid/Bulk modulus");
    material.check(input);
    if (is_infinite)
      return;
    const std::string path = "Fluid/Bulk modulus";
    input.require(bulk_modulus_text.find_first_of("0123456789") !=
                    std::string::npos,
                  path,
                  "allowed are a positive number [Pa] and \"infinite\".");
    const double modulus = entry_values::number(input, path, bulk_modulus_text);
    input.require(modulus > 0. && modulus <= largest_modulus,
                  path,
                  "must be greater than zero and at most 1e30 [Pa], or "
                  "\"infinite\".");
    volume_law = {modulus, volume_law_name == "logarithmic"};
  }
} // namespace seiche
