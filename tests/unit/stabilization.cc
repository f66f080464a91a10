// SPDX-License-Identifier: LGPL-2.1-or-later
// tau1 and tau2 of a cell: c_2 h^2/tau1, borne by the weight of a row of cells
// in large steps, shortened by T_c in small ones, below a finite bulk modulus,
// and the founding paper's as it is.
#include <seiche/formulation/stabilization.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace
{
  using seiche::StabilizationParameters;

  constexpr double density = 1000., h = 0.1, g = 10.;

  seiche::Tau
  tau(const double                   dt,
      const StabilizationParameters &parameters,
      const double bulk_modulus = std::numeric_limits<double>::infinity())
  {
    seiche::StepCoefficients step;
    step.dt      = dt;
    step.theta   = 0.5;
    step.inertia = 2. / (dt * dt);
    step.rate    = 1. / dt;
    return seiche::Stabilization(parameters)
      .evaluate({step,
                 {density, /*viscosity=*/0.},
                 bulk_modulus,
                 h,
                 1,
                 /*speed=*/0.,
                 g});
  }

  void
  say(const std::string &text, const double value, const double expected)
  {
    const bool right = std::abs(value - expected) < 1e-12 * expected;
    std::cout << text << ": ";
    if (right)
      std::cout << "yes\n";
    else
      std::cout << "NO, " << value << " instead of " << expected << '\n';
  }
} // namespace

int
main()
{
  StabilizationParameters p;
  const double small = 0.01, large = 0.3, border = 0.1 / std::sqrt(20.);
  const auto   inertia = [](const double dt) { // rho C_a
    return 2. * density / (dt * dt);
  };
  say("tau1, small step", tau(small, p).momentum, 1. / inertia(small));
  say("tau1, large step", tau(large, p).momentum, 1. / inertia(large));
  say("tau2, small step",
      tau(small, p).continuity,
      0.1 * h * h * inertia(small));
  say("tau2, large step: that of sqrt(h/(20 g))",
      tau(large, p).continuity,
      0.1 * h * h * inertia(border));
  say("tau2, finite bulk modulus",
      tau(large, p, 200.).continuity,
      1. / (1. / (0.1 * h * h * inertia(border)) + 1. / 200.));
  p.continuity_time = 0.05;
  say("tau2 with T_c",
      tau(small, p).continuity,
      0.2 * 0.1 * h * h * inertia(small));
  p                    = StabilizationParameters();
  p.continuity_factor  = 0.;
  p.continuity_modulus = 7.;
  say("K_num alone", tau(large, p).continuity, 7.);
  p     = StabilizationParameters();
  p.tau = "paper"; // |v| floored at h/dt
  say("tau2 of the paper's tau, large step",
      tau(large, p).continuity,
      0.1 * h * h * density / (large * large));
}
