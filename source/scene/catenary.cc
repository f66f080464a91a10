// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/catenary.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/symmetric_tensor.h>

#include <fmt/format.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Where the upper end is for the forces at it, and the derivative.
    struct Reach
    {
      Tensor<1, 2>          place; // across, up [m]
      SymmetricTensor<2, 2> slope; // by horizontal and vertical force [m/N]
    };

    Reach
    reach(const Catenary &line, const Tensor<1, 2> &force, const bool lies)
    {
      const double w = line.weight, L = line.length, EA = line.stiffness;
      const double H = force[0], V = force[1];
      const double upper = V / H, r = std::hypot(1., upper);
      Reach        result;
      if (lies) // a part of the line
        {
          result.place[0] = L - V / w + H / w * std::asinh(upper) + H * L / EA;
          result.place[1] = H / w * (r - 1.) + V * V / (2. * EA * w);
          result.slope[0][0] = (std::asinh(upper) - upper / r) / w + L / EA;
          result.slope[0][1] = (1. / r - 1.) / w;
          result.slope[1][1] = upper / r / w + V / (EA * w);
          return result;
        }
      const double lower = (V - w * L) / H, s = std::hypot(1., lower);
      const double angles = std::asinh(upper) - std::asinh(lower);
      result.place[0]     = H / w * angles + H * L / EA;
      result.place[1]     = H / w * (r - s) + (V - 0.5 * w * L) * L / EA;
      result.slope[0][0]  = (angles - upper / r + lower / s) / w + L / EA;
      result.slope[0][1]  = (1. / r - 1. / s) / w;
      result.slope[1][1]  = (upper / r - lower / s) / w + L / EA;
      return result;
    }

    /// Forces to begin with (Jonkman 2007, eq. 2-39 to 2-41).
    Tensor<1, 2>
    guess(const Catenary &line, const double across, const double up)
    {
      const double slack = line.length * line.length - up * up;
      double       sag   = 0.2; // of a taut line
      if (across == 0.)
        sag = 1e6;
      else if (slack > across * across)
        sag = std::sqrt(3. * (slack / (across * across) - 1.));
      Tensor<1, 2> result;
      result[0] = std::max(0.5 * line.weight * across / sag,
                           1e-6 * line.weight * line.length);
      result[1] = 0.5 * line.weight * (up / std::tanh(sag) + line.length);
      return result;
    }
  } // namespace

  Catenary::Ends
  Catenary::ends(const double across,
                 const double up,
                 const bool   on_ground) const
  {
    constexpr unsigned int most_iterations = 200;
    constexpr double       round_off       = 1e-12; // of the length
    const bool             has_ground      = on_ground && up >= 0.;
    const double           w               = weight;
    // hangs straight down, the rest of it in a heap on the ground
    const double hanging =
      stiffness / w * (std::sqrt(1. + 2. * w * up / stiffness) - 1.);
    if (has_ground && across <= length - hanging)
      return {0., w * hanging, 0., length - hanging};

    Tensor<1, 2> target;
    target[0]       = across;
    target[1]       = up;
    const auto lies = [&](const Tensor<1, 2> &force) {
      return has_ground && force[1] < w * length;
    };
    const auto is_there = [&](const Tensor<1, 2> &missing) {
      return missing.norm() <= round_off * (length + across + std::abs(up));
    };
    Tensor<1, 2> force = guess(*this, across, up);
    Reach        here  = reach(*this, force, lies(force));
    for (unsigned int i = 0; i < most_iterations; ++i)
      {
        const Tensor<1, 2> missing = target - here.place;
        if (is_there(missing))
          break;
        const Tensor<1, 2> change = invert(here.slope) * missing;
        Tensor<1, 2>       best   = force;
        Reach              there  = here;
        // the map is the gradient of a convex function: some share serves
        for (double share = 1.; share > 1e-10; share *= 0.5)
          {
            best = force + share * change;
            if (!(best[0] > 0.1 * force[0]))
              continue;
            there = reach(*this, best, lies(best));
            if ((target - there.place).norm() < missing.norm())
              break;
          }
        if (!((target - there.place).norm() < missing.norm()))
          break;
        force = best;
        here  = there;
      }
    const double error = (target - here.place).norm();
    if (!(error <= 1e-6 * length))
      throw NumericalError(fmt::format(
        "No equilibrium was found for a mooring line of {:.6g} m whose upper "
        "end is {:.6g} m beside and {:.6g} m above the lower one.",
        length,
        across,
        up));
    const double lower = force[1] - w * length; // vertical, at the anchor
    if (lies(force))
      return {force[0], force[1], force[0], -lower / w};
    return {force[0], force[1], std::hypot(force[0], lower), 0.};
  }
} // namespace seiche
