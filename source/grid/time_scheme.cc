// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/bossak.h>
#include <seiche/grid/for_each_local.h>
#include <seiche/grid/generalized_midpoint.h>
#include <seiche/grid/time_scheme.h>
#include <seiche/parameters/input_file.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// One row of the table of schemes.
    template <int dim>
    struct SchemeEntry
    {
      const char *name;
      const char *entry; ///< of subsection "Time" that it alone reads, or empty
      const char *papers; ///< keys of doc/references.bib
      std::unique_ptr<TimeScheme<dim>> (*make)(const TimeSchemeParameters &,
                                               const bool is_incompressible);
    };

    template <int dim>
    constexpr std::array<SchemeEntry<dim>, 3> scheme_table = {
      {{"generalized midpoint",
        "Rho infinity",
        "",
        [](const TimeSchemeParameters &p,
           const bool is_incompressible) -> std::unique_ptr<TimeScheme<dim>> {
          return std::make_unique<GeneralizedMidpoint<dim>>(
            p.rho_infinity,
            p.pressure_order == "second" && p.rho_infinity == 1. &&
              is_incompressible,
            p.is_elastic_at_end());
        }},
       {"bossak",
        "Bossak alpha",
        "wood1980",
        [](const TimeSchemeParameters &p,
           const bool) -> std::unique_ptr<TimeScheme<dim>> {
          return std::make_unique<Bossak<dim>>(p.bossak_alpha);
        }},
       {"newmark",
        "",
        "newmark1959",
        [](const TimeSchemeParameters &,
           const bool) -> std::unique_ptr<TimeScheme<dim>> {
          return std::make_unique<Bossak<dim>>(0.);
        }}}};

    std::string
    scheme_names()
    {
      std::string names;
      for (const auto &entry : scheme_table<2>)
        names += (names.empty() ? "" : "|") + std::string(entry.name);
      return names;
    }
  } // namespace

  void
  TimeSchemeParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Time");
    prm.add_parameter("Scheme",
                      scheme,
                      "Time integration. generalized midpoint: second order "
                      "for Rho infinity = 1, no acceleration history; bossak "
                      "and newmark (the founding paper's) carry an "
                      "acceleration on the points",
                      Patterns::Selection(scheme_names()));
    prm.add_parameter("Rho infinity",
                      rho_infinity,
                      "Spectral radius of the generalized midpoint scheme at "
                      "infinite frequency, theta = 1/(1 + rho): 1 keeps "
                      "energy, 0 is backward Euler [-]",
                      Patterns::Double(0., 1.));
    prm.add_parameter("Bossak alpha",
                      bossak_alpha,
                      "Weight of the old acceleration in Bossak's inertia [-]",
                      Patterns::Double(-1. / 3., 0.));
    prm.add_parameter("Pressure order",
                      pressure_order,
                      "Order in the step of the pressure of the generalized "
                      "midpoint scheme with Rho infinity = 1 (below 1 all is "
                      "of first order) with infinite Bulk modulus. second: the "
                      "constraint leaves the velocity at the end of the step "
                      "without divergence; first: it keeps the volume of the "
                      "step's own path",
                      Patterns::Selection("first|second"));
    prm.add_parameter("Elastic pressure",
                      elastic_pressure,
                      "When the volume ratio in p = -kappa (J - 1) is taken, "
                      "finite Bulk modulus only. end: at the end of the step, "
                      "first order, damps sound; middle: between start and end "
                      "as other forces, second order for Rho infinity = 1, for "
                      "sound that the steps resolve, c dt/h about 1 and less",
                      Patterns::Selection("end|middle"));
    prm.leave_subsection();
  }

  void
  TimeSchemeParameters::check(const InputFile &input,
                              const bool       is_incompressible) const
  {
    const std::string section = "Time/";
    for (const auto &row : scheme_table<2>)
      {
        input.read_only_if(scheme == row.name,
                           section + row.entry,
                           section + "Scheme = " + row.name);
        if (scheme == row.name)
          input.cites(row.papers);
      }
    input.read_only_if(!needs_acceleration() && is_second_order() &&
                         is_incompressible,
                       section + "Pressure order",
                       "Scheme = generalized midpoint, Rho infinity = 1, the "
                       "mixed form and an infinite Fluid/Bulk modulus");
  }

  bool
  TimeSchemeParameters::needs_acceleration() const
  {
    return make_time_scheme<2>(*this, /*is_incompressible=*/true)
      ->needs_acceleration();
  }

  template <int dim>
  void
  TimeScheme<dim>::predict(GridState<dim> &state) const
  {
    for_each_local(state.velocity_start, [&](const unsigned int i) {
      state.displacement().local_element(i) =
        state.dt * state.velocity_start.local_element(i);
    });
    if (state.has_pressure())
      for_each_local(state.pressure_guess, [&](const unsigned int i) {
        state.pressure().local_element(i) =
          state.pressure_guess.local_element(i);
      });
    state.solution.update_ghost_values();
  }

  template <int dim>
  std::unique_ptr<TimeScheme<dim>>
  make_time_scheme(const TimeSchemeParameters &parameters,
                   const bool                  is_incompressible)
  {
    for (const auto &entry : scheme_table<dim>)
      if (parameters.scheme == entry.name)
        return entry.make(parameters, is_incompressible);
    AssertThrow(false, ExcInternalError()); // the pattern refuses other names
    return nullptr;
  }

  template class TimeScheme<2>;
  template class TimeScheme<3>;
  template std::unique_ptr<TimeScheme<2>>
  make_time_scheme<2>(const TimeSchemeParameters &, const bool);
  template std::unique_ptr<TimeScheme<3>>
  make_time_scheme<3>(const TimeSchemeParameters &, const bool);
} // namespace seiche
