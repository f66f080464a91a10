// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/formulation/stabilization.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  void
  StabilizationParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Formulation");
    prm.add_parameter("Stabilization",
                      stabilization,
                      "Subscales of the mixed form: ASGS or none [-]",
                      Patterns::Selection("ASGS|none"));
    prm.add_parameter("Tau",
                      tau,
                      "Stabilization parameters: transient (inertia and "
                      "viscosity; finite for fluid at rest) or paper "
                      "(equation 25 of the founding paper)",
                      Patterns::Selection("transient|paper"));
    prm.add_parameter("Tau speed floor",
                      speed_floor,
                      "Tau = paper: smallest speed in equation 25, which is "
                      "infinite for fluid at rest [cells a step]",
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
                      "Factor c_2 of tau2 = c_2 h^2/tau1; 0.1 keeps energy, 1 "
                      "suits disordered points over long times [-]",
                      Patterns::Double(0.));
    prm.add_parameter(
      "Tau continuity time",
      continuity_time,
      "Time T_c: tau2 of smaller steps is multiplied by dt/T_c, "
      "or it would resist div v as a viscosity that grows as "
      "1/dt; 0: none [s]",
      Patterns::Double(0.));
    prm.leave_subsection();
  }

  double
  StabilizationParameters::inverse_transient_tau(
    const StepCoefficients &coefficients,
    const double            density,
    const double            viscosity,
    const double            h,
    const unsigned int      degree) const
  {
    const double k4 = static_cast<double>(degree * degree) * degree * degree;
    return inertia_factor * density * coefficients.inertia +
           viscous_factor * 2. * viscosity * coefficients.rate * k4 / (h * h);
  }

  Tau
  StabilizationParameters::evaluate(const StepCoefficients &coefficients,
                                    const double            density,
                                    const double            bulk_modulus,
                                    const double            viscosity,
                                    const double            h,
                                    const unsigned int      degree,
                                    const double            speed) const
  {
    Tau result;
    if (!is_active())
      return result;
    double inverse = 0.;
    if (tau == "transient")
      inverse =
        inverse_transient_tau(coefficients, density, viscosity, h, degree);
    else
      {
        const double floored =
          std::max(speed, speed_floor * h / coefficients.dt);
        inverse = viscous_factor * 2. * viscosity / (h * h * coefficients.dt) +
                  inertia_factor * density * floored / (h * coefficients.dt);
      }
    result.momentum   = 1. / inverse;
    result.continuity = continuity_factor * h * h * inverse;
    if (continuity_time > coefficients.dt)
      result.continuity *= coefficients.dt / continuity_time;
    result.continuity /= 1. + result.continuity / bulk_modulus;
    return result;
  }
} // namespace seiche
