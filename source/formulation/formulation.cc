// SPDX-License-Identifier: LGPL-2.1-or-later
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
      Formulation<dim> (*make)(const FormulationParameters &,
                               const FreeSurfaceParameters &,
                               const VolumeLaw &,
                               const VolumeFactors &);
      const char *description;
    };

    template <int dim>
    constexpr std::array<FormulationEntry<dim>, 2> formulation_table = {
      {{"displacement-pressure",
        make_displacement_pressure<dim>,
        "mixed, with subscales"},
       {"displacement",
        make_displacement<dim>,
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
  void
  Formulation<dim>::update_pressures(PointCloud<dim> &points) const
  {
    const double *ratio    = points.data(PointColumn::volume_ratio);
    double       *pressure = points.data(PointColumn::pressure);
    for (std::size_t p = 0; p < points.size(); ++p)
      pressure[p] = -volume_law.bulk_modulus * volume_law.strain(ratio[p]);
  }

  template <int dim>
  void
  Formulation<dim>::update_volume_ratios(PointCloud<dim> &points) const
  {
    const double *pressure = points.data(PointColumn::pressure);
    double       *ratio    = points.data(PointColumn::volume_ratio);
    for (std::size_t p = 0; p < points.size(); ++p)
      ratio[p] = volume_law.ratio(-pressure[p] / volume_law.bulk_modulus);
  }

  template <int dim>
  Formulation<dim>
  make_formulation(const FormulationParameters &parameters,
                   const FreeSurfaceParameters &free_surface,
                   const VolumeLaw             &volume_law,
                   const VolumeFactors         &factors)
  {
    for (const auto &entry : formulation_table<dim>)
      if (parameters.name == entry.name)
        return entry.make(parameters, free_surface, volume_law, factors);
    AssertThrow(false, ExcInternalError()); // the pattern refuses other names
    return {};
  }

#define INSTANTIATE(dim)                           \
  template struct Formulation<dim>;                \
  template Formulation<dim> make_formulation<dim>( \
    const FormulationParameters &,                 \
    const FreeSurfaceParameters &,                 \
    const VolumeLaw &,                             \
    const VolumeFactors &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
