// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/scene_scales.h>

#include <deal.II/base/mpi.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double hardly_meant = 20.;   // speed over sqrt(g H)
    constexpr double mostly       = 0.7;   // of the body force
    constexpr double hardly_moves = 1e-10; // cells in a step

    /// Cells that sound may cross in a step: doc/methods.md, stability.
    constexpr double stiffest = 10.;
    /// Least bulk modulus over rho g H, the same.
    constexpr double softest = 5.;
  } // namespace

  template <int dim>
  SceneScales::SceneScales(const PointCloud<dim> &points,
                           const BodyForce<dim>  &body_force,
                           const double           half_spacing)
  {
    const double lowest = std::numeric_limits<double>::lowest();
    // top, minus bottom, minus the smallest edge, square of the speed
    std::array<double, 4> largest = {{lowest, lowest, lowest, 0.}};
    Point<dim>            centre;
    for (std::size_t p = 0; p < points.size(); ++p)
      {
        const Point<dim> x = points.position(p);
        centre += (x - Point<dim>()) / static_cast<double>(points.n_global());
        largest[0]    = std::max(largest[0], x[dim - 1]);
        largest[1]    = std::max(largest[1], -x[dim - 1]);
        double square = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          square += std::pow(points.data(PointColumn::velocity, d)[p], 2);
        largest[3] = std::max(largest[3], square);
      }
    for (unsigned int cell = 0; cell < points.locator.n_owned(); ++cell)
      for (unsigned int d = 0; d < dim; ++d)
        largest[2] = std::max(largest[2], -points.locator.extent(cell)[d]);
    for (double &value : largest)
      value = Utilities::MPI::max(value, points.communicator);
    for (unsigned int d = 0; d < dim; ++d)
      centre[d] = Utilities::MPI::sum(centre[d], points.communicator);

    const Tensor<1, dim> b = body_force.value(centre, /*t=*/0.);
    depth                  = largest[0] + largest[1] + 2. * half_spacing;
    gravity                = b.norm();
    upwards                = b[dim - 1];
    speed                  = std::sqrt(largest[3]);
    smallest_cell          = -largest[2];
  }

  double
  SceneScales::wave_speed() const
  {
    return std::sqrt(gravity * depth);
  }

  double
  SceneScales::fastest() const
  {
    return std::max({wave_speed(), speed, walls});
  }

  bool
  SceneScales::step_is_round_off() const
  {
    const double way =
      std::max({speed, walls, gravity * step}) * step / smallest_cell;
    return way > 0. && way < hardly_moves;
  }

  double
  SceneScales::ordinary_step() const
  {
    return 0.5 * smallest_cell / fastest();
  }

  double
  SceneScales::expected_step() const
  {
    return std::min(step, 2. * ordinary_step());
  }

  std::string
  SceneScales::text() const
  {
    std::string result = fmt::format("depth {:.3g} m, ", depth);
    if (gravity > 0.)
      result += fmt::format("sqrt(g H) {:.3g} m/s, rho g H {:.3g} Pa",
                            wave_speed(),
                            density * gravity * depth);
    else
      result += "no body force at the start";
    if (speed > 0.)
      result += fmt::format("; fastest {:.3g} m/s", speed);
    if (speed > 0. && gravity > 0.)
      result += fmt::format(", Froude number {:.2g}", speed / wave_speed());
    if (walls > 0.)
      result += fmt::format("; walls move with up to {:.3g} m/s", walls);
    if (viscosity > 0. && fastest() > 0.)
      result += fmt::format("; Reynolds number {:.2g}",
                            density * fastest() * depth / viscosity);
    if (fastest() > 0.)
      result += fmt::format("; in {} {:.3g} s {:.2g} cells",
                            is_fixed ? "steps of" : "the largest step,",
                            step,
                            fastest() * step / smallest_cell);
    return result;
  }

  std::vector<std::string>
  SceneScales::doubts() const
  {
    std::vector<std::string> result;
    if (upwards > mostly * gravity)
      result.push_back("the body force points upwards: gravity is 0; -9.81 in "
                       "2D, 0; 0; -9.81 in 3D");
    if (gravity > 0. && speed > hardly_meant * wave_speed())
      result.push_back(fmt::format(
        "the fluid starts with {:.3g} m/s, {:.2g} times sqrt(g H): are all "
        "entries in SI units?",
        speed,
        speed / wave_speed()));
    if (const std::string doubt = doubt_of_sound(); !doubt.empty())
      result.push_back(doubt);
    return result;
  }

  std::string
  SceneScales::doubt_of_sound() const
  {
    const double sound = std::sqrt(modulus / density);
    const double cells = sound * step / smallest_cell;
    if (cells <= stiffest)
      return "";
    const double soft = density * std::pow(stiffest * smallest_cell / step, 2);
    return fmt::format(
      "sound crosses {:.3g} cells in a step: above {:.0f} the irreducible form "
      "may gain energy where water meets; what may help: Formulation/Name = "
      "displacement-pressure, {}",
      cells,
      stiffest,
      soft > softest * density * gravity * depth ?
        fmt::format("Fluid/Bulk modulus = {:.2g}", soft) :
        fmt::format("Time/Step = {:.2g}", stiffest * smallest_cell / sound));
  }

  template SceneScales::SceneScales(const PointCloud<2> &,
                                    const BodyForce<2> &,
                                    const double);
  template SceneScales::SceneScales(const PointCloud<3> &,
                                    const BodyForce<3> &,
                                    const double);
} // namespace seiche
