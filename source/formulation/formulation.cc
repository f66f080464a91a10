// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/displacement.h>
#include <seiche/formulation/displacement_pressure_vms.h>
#include <seiche/formulation/formulation.h>
#include <seiche/parameters/input_file.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct FormulationEntry
    {
      const char *name;
      std::unique_ptr<Formulation<dim>> (*make)(const VolumeLaw &,
                                                const FormulationParameters &);
      const char *description;
    };

    template <int dim, typename Type>
    std::unique_ptr<Formulation<dim>>
    make(const VolumeLaw &volume_law, const FormulationParameters &parameters)
    {
      return std::make_unique<Type>(volume_law, parameters);
    }

    template <int dim>
    constexpr std::array<FormulationEntry<dim>, 2> formulation_table = {
      {{"displacement-pressure",
        make<dim, DisplacementPressureVMS<dim>>,
        "mixed, with subscales"},
       {"displacement",
        make<dim, Displacement<dim>>,
        "irreducible, pressure from the bulk modulus"}}};
  } // namespace

  void
  FormulationParameters::add_parameters(ParameterHandler &prm)
  {
    std::string names, text = "Weak form.";
    for (const auto &entry : formulation_table<2>)
      {
        names += (names.empty() ? "" : "|") + std::string(entry.name);
        text += std::string(" ") + entry.name + ": " + entry.description + ";";
      }
    text.back() = '.';
    prm.enter_subsection("Formulation");
    prm.add_parameter("Name", name, text, Patterns::Selection(names));
    prm.add_parameter("Element degree",
                      degree,
                      "Degree of the elements, the same for displacement and "
                      "pressure: 1 or 2. With 2, cells at the surface are of "
                      "degree 1; the others take a consistent mass in "
                      "the transfers (Transfer/Mass) and need 3 points per "
                      "cell and direction at least, better 4 [-]",
                      Patterns::Integer(1, max_degree));
    prm.add_parameter("Inertia",
                      inertia,
                      "Mass matrix of the momentum balance: consistent, or "
                      "lumped as in the code of the founding paper, which "
                      "nodes with little mass stand better [-]",
                      Patterns::Selection("consistent|lumped"));
    prm.leave_subsection();
    stabilization.add_parameters(prm);
  }

  void
  FormulationParameters::check(const InputFile &input) const
  {
    stabilization.check(input, is_mixed());
    input.require(degree == 1 || !lumps_inertia(),
                  "Formulation/Inertia",
                  "lumped masses make elements of degree 2 less accurate than "
                  "those of degree 1: set it to consistent, or Element degree "
                  "to 1");
  }

  template <int dim>
  std::unique_ptr<Formulation<dim>>
  make_formulation(const FormulationParameters &parameters,
                   const VolumeLaw             &volume_law)
  {
    for (const auto &entry : formulation_table<dim>)
      if (parameters.name == entry.name)
        return entry.make(volume_law, parameters);
    AssertThrow(false, ExcInternalError()); // the pattern refuses other names
    return nullptr;
  }

#define INSTANTIATE(dim)                                            \
  template std::unique_ptr<Formulation<dim>> make_formulation<dim>( \
    const FormulationParameters &, const VolumeLaw &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
