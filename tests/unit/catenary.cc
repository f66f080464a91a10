// SPDX-License-Identifier: LGPL-2.1-or-later
// Mooring lines: the forces at their ends carry each of their parts (the line
// summed up part by part), follow from a potential, and go over smoothly from a
// line that lies on the ground to one that hangs.
#include <seiche/scene/catenary.h>

#include <cmath>
#include <iostream>
#include <string>

#include "verdict.h"

namespace
{
  using seiche::Catenary;

  /// Where the upper end is if these forces are at it: the sum over the line of
  /// its parts, each along its own tension, stretched by it.
  void
  sum_up(const Catenary       &line,
         const Catenary::Ends &ends,
         const bool            has_ground,
         double               &across,
         double               &up)
  {
    constexpr unsigned int n = 200000;
    across = up     = 0.;
    const double ds = line.length / n;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double below = (i + 0.5) * ds; // of the line
        double       V = ends.vertical - line.weight * (line.length - below);
        if (has_ground && V < 0.)
          V = 0.;
        const double tension = std::hypot(ends.horizontal, V);
        across += ends.horizontal * (1. / tension + 1. / line.stiffness) * ds;
        up += V * (1. / tension + 1. / line.stiffness) * ds;
      }
  }

  void
  test(const std::string &title,
       const Catenary    &line,
       const double       across,
       const double       up,
       const bool         on_ground = true)
  {
    const Catenary::Ends ends       = line.ends(across, up, on_ground);
    const bool           has_ground = on_ground && up >= 0.;
    double               x, z;
    sum_up(line, ends, has_ground, x, z);
    const bool fits = std::hypot(x - across, z - up) < 1e-7 * line.length;

    // work in a small rectangle is zero: dH/dz = dV/dx
    const double e   = 1e-5 * line.length;
    const double H_z = (line.ends(across, up + e, on_ground).horizontal -
                        line.ends(across, up - e, on_ground).horizontal) /
                       (2. * e);
    const double V_x = (line.ends(across + e, up, on_ground).vertical -
                        line.ends(across - e, up, on_ground).vertical) /
                       (2. * e);
    const bool has_potential =
      std::abs(H_z - V_x) <
      1e-4 * (std::abs(H_z) + std::abs(V_x)) + 1e-6 * line.weight;
    std::cout << title << ": H " << ends.horizontal << ", V " << ends.vertical
              << ", at anchor " << ends.anchor << ", lies " << ends.lying
              << "; carries its parts: " << verdict(fits)
              << ", has a potential: " << verdict(has_potential) << '\n';
  }
} // namespace

int
main()
{
  std::cout.precision(6);
  const Catenary chain{10., 50., 1e8}, rope{10., 1., 2000.};
  test("chain, a part lies", chain, 8., 4.);
  test("chain, hardly lies", chain, 8.8, 4.);
  test("chain, hangs", chain, 9.1, 4.);
  test("chain, taut", chain, 9.17, 4.);
  test("chain, no ground", chain, 8., 4., /*on_ground=*/false);
  test("chain from above", chain, 5., -6.);
  test("chain, both ends level", chain, 9., 0., /*on_ground=*/false);
  test("rope, slack", rope, 6., 5.);
  test("rope, stretched", rope, 12., 5.);
  test("rope, upright and stretched", rope, 1e-3, 11.);

  const auto heap = chain.ends(2., 3., /*on_ground=*/true);
  std::cout << "chain, in a heap: H " << heap.horizontal << ", V "
            << heap.vertical << ", lies " << heap.lying << '\n';

  // over the place where the anchor begins to lift
  double largest = 0., before = 0., steepest = 0.;
  for (unsigned int i = 0; i <= 2000; ++i)
    {
      const auto   ends = chain.ends(8.5 + 0.0003 * i, 4., /*on_ground=*/true);
      const double change = i == 0 ? 0. : ends.horizontal - before;
      if (i > 1)
        largest = std::max(largest, change / std::max(steepest, 1e-3));
      steepest = change;
      before   = ends.horizontal;
    }
  std::cout << "no jump on the way from lying to taut: "
            << verdict(largest < 1.1) << '\n';
}
