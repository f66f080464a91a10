// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/stabilization.h>
#include <seiche/parameters/input_file.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <array>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// K_num at most, in h^2/tau1: more costs Krylov iterations and gains
    /// nothing.
    constexpr double largest_modulus = 2.;

    /// tau2 is at least that of a step of (h/(b times this))^(1/2): below the
    /// weight of a row of cells nothing holds the points' volumes against it,
    /// and water at rest becomes restless (doc/journal/cut_cells.md).
    constexpr double weight_factor = 20.;

    /// c_1 2 mu c_r k^4/h^2.
    double
    viscous_part(const StabilizationParameters &p, const TauArguments &cell)
    {
      const double k4 = static_cast<double>(cell.degree * cell.degree) *
                        cell.degree * cell.degree;
      return p.viscous_factor * cell.fluid.stiffness(cell.step.rate) * k4 /
             (cell.h * cell.h);
    }

    double
    transient(const StabilizationParameters &p, const TauArguments &cell)
    {
      return p.inertia_factor * cell.fluid.inertia(cell.step.inertia) +
             viscous_part(p, cell);
    }

    /// |v|, which would make tau1 infinite where it is zero.
    double
    floored_speed(const StabilizationParameters &p, const TauArguments &cell)
    {
      return std::max(cell.speed, p.speed_floor * cell.h / cell.step.dt);
    }

    /// One row of the table of tau1.
    struct TauEntry
    {
      const char *name;
      const char *papers;     ///< keys of doc/references.bib
      bool        is_uniform; ///< needs no speed
      bool        has_inertia;
      double (*inverse)(const StabilizationParameters &, const TauArguments &);
    };

    const std::array<TauEntry, 3> tau_table = {
      {{"transient", "codina2002 badia2009", true, true, transient},
       {"root of squares",
        "shakib1991",
        true,
        true,
        [](const StabilizationParameters &p, const TauArguments &cell) {
          return std::hypot(p.inertia_factor *
                              cell.fluid.inertia(cell.step.inertia),
                            viscous_part(p, cell));
        }},
       {"paper",
        "codina2000",
        false,
        false,
        [](const StabilizationParameters &p, const TauArguments &cell) {
          const double dt = cell.step.dt;
          return p.viscous_factor * cell.fluid.stiffness(1. / dt) /
                   (cell.h * cell.h) +
                 p.inertia_factor * cell.fluid.inertia(floored_speed(p, cell)) /
                   (cell.h * dt);
        }}}};

    const TauEntry &
    tau_entry(const std::string &name)
    {
      for (const TauEntry &entry : tau_table)
        if (name == entry.name)
          return entry;
      AssertThrow(false, ExcInternalError()); // the pattern refuses other names
      return tau_table[0];
    }

    /// One row of the table of subscales.
    struct SubscaleEntry
    {
      const char *name;
      const char *papers; ///< keys of doc/references.bib
    };

    constexpr std::array<SubscaleEntry, 4> subscale_table = {
      {{"ASGS", "codina2000"},
       {"OSGS", "codina2000 codina2002"},
       {"split OSGS", "codina2008"},
       {"none", ""}}};

    template <typename Table>
    std::string
    names_of(const Table &table)
    {
      std::string names;
      for (const auto &entry : table)
        names += (names.empty() ? "" : "|") + std::string(entry.name);
      return names;
    }
  } // namespace

  bool
  StabilizationParameters::is_quasi_static() const
  {
    return !tau_entry(tau).has_inertia;
  }

  void
  StabilizationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Formulation");
    prm.add_parameter("Stabilization",
                      stabilization,
                      "Subscales of the mixed form: ASGS (whole residual), "
                      "OSGS (its part orthogonal to the finite elements), "
                      "split OSGS (of the pressure gradient only) or none [-]",
                      Patterns::Selection(names_of(subscale_table)));
    prm.add_parameter("Subscale residual",
                      subscale_residual,
                      "What the momentum's subscale resolves with ASGS and "
                      "OSGS: the whole residual, or body force, viscous force "
                      "and pressure gradient without inertia, as in the code "
                      "of the founding paper for fluids; that one is wrong by "
                      "tau1 rho a where the fluid accelerates, and has its "
                      "place in the paper's recipe with its small steps [-]",
                      Patterns::Selection("whole|without inertia"));
    prm.add_parameter("Projection updates",
                      projection_updates,
                      "OSGS: Newton iterations of a step after which the "
                      "residual is projected again; at the first guess it "
                      "always is [-]",
                      Patterns::Integer(1));
    prm.add_parameter("Projection mass",
                      projection_mass,
                      "OSGS: mass matrix of the projection [-]",
                      Patterns::Selection("lumped|consistent"));
    add_tau_parameters(prm);
    prm.leave_subsection();
  }

  void
  StabilizationParameters::add_tau_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Tau",
                      tau,
                      "Stabilization parameters: transient (inertia and "
                      "viscosity added; finite for fluid at rest), root of "
                      "squares (of the same two) or paper (quasi-static, "
                      "equation 25 of the founding paper)",
                      Patterns::Selection(names_of(tau_table)));
    prm.add_parameter("Tau speed floor",
                      speed_floor,
                      "Tau = paper: smallest speed in equation 25, which is "
                      "infinite for fluid at rest; with Subscale residual = "
                      "whole the inertia of the subscales outweighs that of "
                      "the flow below about 0.5 (Newmark: 1), and splashes "
                      "stop [cells a step]",
                      Patterns::Double(1e-12));
    prm.add_parameter("Tau inertia factor",
                      inertia_factor,
                      "Factor c_d of the inertia term in 1/tau1 [-]",
                      Patterns::Double(1e-6));
    prm.add_parameter("Tau viscous factor",
                      viscous_factor,
                      "Factor c_1 of the viscous term in 1/tau1 [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Tau continuity factor",
                      continuity_factor,
                      "Factor c_2 of tau2 = c_2 h^2/tau1 (of a step of "
                      "sqrt(h/(20 b)) at most, b the body force); 0.1 keeps "
                      "energy, 5 suits disordered points at rest [-]",
                      Patterns::Double(0.));
    prm.add_parameter("Tau continuity modulus",
                      continuity_modulus,
                      "K_num, added to tau2; at most 2 h^2/tau1 of it counts "
                      "[Pa]",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Tau continuity time",
      continuity_time,
      "Time T_c: c_2 h^2/tau1 of smaller steps is multiplied by dt/T_c, "
      "or it would resist div v as a viscosity that grows as "
      "1/dt; 0: none [s]",
      Patterns::Double(0.));
  }

  void
  StabilizationParameters::check(const InputFile &input,
                                 const bool       is_mixed) const
  {
    const std::string section = "Formulation/";
    input.read_only_if(is_mixed,
                       section + "Stabilization",
                       "Formulation/Name = displacement-pressure");
    const bool has_subscales = is_mixed && is_active();
    for (const SubscaleEntry &entry : subscale_table)
      if (is_mixed && stabilization == entry.name)
        input.cites(entry.papers);
    if (has_subscales)
      input.cites(tau_entry(tau).papers);
    for (const char *entry : {"Tau",
                              "Tau inertia factor",
                              "Tau viscous factor",
                              "Tau continuity factor",
                              "Tau continuity modulus",
                              "Tau continuity time"})
      input.read_only_if(has_subscales,
                         section + entry,
                         "the subscales of the mixed form "
                         "(Formulation/Stabilization)");
    for (const char *entry : {"Projection updates", "Projection mass"})
      input.read_only_if(is_mixed && is_orthogonal(),
                         section + entry,
                         "Formulation/Stabilization = OSGS or split OSGS");
    input.read_only_if(has_subscales && !tau_entry(tau).is_uniform,
                       section + "Tau speed floor",
                       "Formulation/Tau = paper");
    input.require(has_inertia() || (is_mixed && is_active() && !is_split()),
                  "Formulation/Subscale residual",
                  "without inertia chooses what the subscales of the mixed "
                  "form with Stabilization = ASGS or OSGS resolve: set "
                  "Subscale residual = whole");
  }

  Stabilization::Stabilization(const StabilizationParameters &p)
    : parameters(p)
    , is_active(p.is_active())
    , projects_lumped(p.projects_lumped())
    , tau_is_uniform(tau_entry(p.tau).is_uniform)
    , bears_weight(tau_entry(p.tau).has_inertia)
    , is_split(p.is_split())
    , has_inertia(p.has_inertia())
    , inverse_tau(*tau_entry(p.tau).inverse)
  {}

  double
  Stabilization::inverse_transient_tau(const TauArguments &cell) const
  {
    return transient(parameters, cell);
  }

  Tau
  Stabilization::evaluate(const TauArguments &cell) const
  {
    Tau result;
    if (!is_active)
      return result;
    const StabilizationParameters &p       = parameters;
    const double                   inverse = inverse_tau(p, cell);
    const double                   scale   = cell.h * cell.h * inverse; // [Pa]
    result.momentum                        = 1. / inverse;
    result.continuity                      = p.continuity_factor * scale;
    if (bears_weight)
      result.continuity =
        std::max(result.continuity,
                 p.continuity_factor * cell.fluid.inertia(cell.step.inertia) *
                   cell.step.dt * cell.step.dt * weight_factor *
                   cell.body_force * cell.h);
    if (p.continuity_time > cell.step.dt)
      result.continuity *= cell.step.dt / p.continuity_time;
    result.continuity +=
      std::min(p.continuity_modulus, largest_modulus * scale);
    result.continuity /= 1. + result.continuity / cell.bulk_modulus;
    return result;
  }
} // namespace seiche
