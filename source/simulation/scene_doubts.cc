// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/scene_scales.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// The part of SceneScales that knows what is hardly meant.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double hardly_meant = 20.;               // speed over sqrt(g H)
    constexpr double mostly       = 0.7;               // of the body force
    constexpr double lying        = 0.05;              // the same
    constexpr double hardly_turns = 0.6 * numbers::PI; // of a tank [rad]

    // cells in a step, where round-off of volumes or of viscous stresses is
    // all that is left: Newton stalls below 1e-9 of the latter
    constexpr double hardly_moves = 1e-10, hardly_creeps = 2e-9,
                     surely_creeps = 1e-6;

    /// Cells that sound may cross in a step: doc/methods.md, stability.
    constexpr double stiffest = 10.;

    /// Least bulk modulus over rho g H, the same.
    constexpr double softest = 5.;
  } // namespace

  bool
  SceneScales::step_is_round_off() const
  {
    const double way    = cells_in(step);
    const bool   creeps = creep_speed() < gravity * step;
    return way > 0. && way < (creeps ? hardly_creeps : hardly_moves);
  }

  std::string
  SceneScales::entry_for_motion() const
  {
    const double most = cells_in(end_time);
    if (most < surely_creeps && creep_speed() < gravity * end_time)
      return fmt::format("Fluid/Dynamic viscosity = {:.1g}",
                         fluid.viscosity * cells_in(step) / surely_creeps);
    const double mover =
      std::max({speed, walls, std::min(wave_speed(), creep_speed())});
    return fmt::format("Time/Step = {:.1g}",
                       std::min(0.5 * smallest_cell / mover, end_time));
  }

  std::vector<std::string>
  SceneScales::doubts() const
  {
    std::vector<std::string> result;
    if (turn > hardly_turns)
      result.push_back(fmt::format(
        "the tank turns by {:.3g} degrees: angles of Tank motion (Rotation, Start) "
        "are in radians (a table of degrees needs Factors = 1, 0.0174533)",
        turn * 180. / numbers::PI));
    else if (upwards > mostly * gravity)
      result.push_back("the body force points upwards: gravity is 0; -9.81 in "
                       "2D, 0; 0; -9.81 in 3D");
    else if (sideways > mostly * gravity && std::abs(upwards) < lying * gravity)
      result.push_back("the body force points to a wall at the side: gravity "
                       "in 3D is 0; 0; -9.81");
    if (gravity > 0. && speed > hardly_meant * wave_speed())
      result.push_back(fmt::format(
        "the fluid starts with {:.3g} m/s, {:.2g} times sqrt(g H): are all "
        "entries in SI units?",
        speed,
        speed / wave_speed()));
    if (thinnest < smallest_cell)
      result.push_back(fmt::format(
        "the fluid body {} is {:.3g} m thick, {:.2g} cells: what flows there "
        "needs Grid/Cell size = {:.2g}, or a refinement",
        thinnest_place,
        thinnest,
        thinnest / smallest_cell,
        0.5 * thinnest));
    if (step_is_round_off())
      result.push_back(fmt::format(
        "the fluid moves by {:.1g} cells in a step, which is round-off; what "
        "may help: {}",
        cells_in(step),
        entry_for_motion()));
    const double weight = pressure_under(tallest_body);
    if (modulus < softest * weight)
      result.push_back(fmt::format(
        "the fluid is compressed by {:.2g} % under its own weight: Fluid/Bulk "
        "modulus should be {:.2g} Pa at least",
        50. * weight / modulus,
        1.1 * softest * weight)); // more than rounding takes
    for (const std::string &name : lost_tracks)
      result.push_back("Tracked point " + name +
                       " lies outside of the fluid: the nearest material point "
                       "is followed");
    if (const std::string doubt = doubt_of_sound(); !doubt.empty())
      result.push_back(doubt);
    return result;
  }

  std::string
  SceneScales::doubt_of_sound() const
  {
    const double cells =
      std::sqrt(modulus / fluid.density) * step / smallest_cell;
    if (is_mixed || cells <= stiffest)
      return "";
    const double soft =
      fluid.density * std::pow(stiffest * smallest_cell / step, 2);
    return fmt::format(
      "sound crosses {:.3g} cells in a step: above {:.0f} the irreducible form "
      "may gain energy where water meets; what may help: Formulation/Name = "
      "displacement-pressure, {}",
      cells,
      stiffest,
      soft > softest * pressure_under(depth) ?
        fmt::format("Fluid/Bulk modulus = {:.2g}", soft) :
        fmt::format("Time/Step = {:.2g}", step * stiffest / cells));
  }
} // namespace seiche
