// SPDX-License-Identifier: LGPL-2.1-or-later
// Forces of stops: of a body on a floor, thrown at it, pulled off, on two legs;
// between two bodies. Rates at the end of the step, sum of momentum.
#include <seiche/solve/body_stops.h>

#include <cmath>
#include <iostream>
#include <string>

namespace
{
  constexpr double dt = 0.1;

  using seiche::BodyStop;

  /// Inertias of the directions, loads on them, rates at the start.
  void
  step(const std::string           &title,
       const std::vector<double>   &inertias,
       const std::vector<double>   &loads,
       const std::vector<double>   &rates,
       const std::vector<BodyStop> &list)
  {
    const unsigned int         n = inertias.size();
    dealii::FullMatrix<double> inverse(n);
    for (unsigned int i = 0; i < n; ++i)
      inverse(i, i) = 1. / inertias[i];
    const dealii::Vector<double> load(loads.begin(), loads.end());
    std::vector<double>          accelerations(n, 0.);

    seiche::BodyStops stops;
    stops.begin(list, dt, n);
    dealii::Vector<double> sum(load);
    std::vector<double>    free(n);
    for (unsigned int i = 0; i < n; ++i)
      free[i] = loads[i] / inertias[i];
    const bool holds = stops.are_missing(free);
    stops.solve(inverse, load, accelerations);
    sum += stops.forces();
    for (unsigned int i = 0; i < n; ++i)
      accelerations[i] = sum(i) / inertias[i];
    std::cout << title << ": " << (holds ? "held" : "free") << ", forces";
    for (unsigned int i = 0; i < n; ++i)
      std::cout << ' ' << stops.forces()(i) + 0.;
    std::cout << ", rates";
    for (unsigned int i = 0; i < n; ++i)
      std::cout << ' '
                << std::round((rates[i] + dt * accelerations[i]) * 1e9) / 1e9 +
                     0.;
    for (const BodyStop &stop : list)
      {
        double rate = stop.rate;
        for (unsigned int i = 0; i < n; ++i)
          rate += dt * stop.way[i] * accelerations[i];
        if (rate < stop.least - 1e-9)
          std::cout << ", comes nearer";
      }
    std::cout << '\n';
  }
} // namespace

int
main()
{
  // a mass of 2 kg
  step("lies", {2.}, {-20.}, {0.}, {{{1.}, 0., 0.}});
  step("is thrown", {2.}, {-20.}, {-3.}, {{{1.}, -3., 0.}});
  step("springs back by half", {2.}, {0.}, {-3.}, {{{1.}, -3., 1.5}});
  step("is pulled off", {2.}, {5.}, {0.}, {{{1.}, 0., 0.}});
  step("leaves", {2.}, {-20.}, {4.}, {{{1.}, 4., 0.}});
  // z and an angle, on legs at -1 and 1 m
  const std::vector<BodyStop> legs = {{{1., -1.}, 0., 0.}, {{1., 1.}, 0., 0.}};
  step("on two legs", {2., 1.}, {-20., 4.}, {0., 0.}, legs);
  step("tilts over one", {2., 1.}, {-20., 30.}, {0., 0.}, legs);
  // two bodies, the second on the first
  step("stacked",
       {2., 1.},
       {-20., -10.},
       {0., 0.},
       {{{1., 0.}, 0., 0.}, {{-1., 1.}, 0., 0.}});
  step("collide", {2., 1.}, {0., 0.}, {1., -2.}, {{{-1., 1.}, -3., 0.}});
  // many stops in one place
  step("a hundred times the same",
       {2.},
       {-20.},
       {-1.},
       std::vector<BodyStop>(100, {{1.}, -1., 0.}));
}
