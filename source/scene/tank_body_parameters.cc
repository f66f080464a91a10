// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of a tank that the fluid moves, and the names of its directions.
#include <seiche/parameters/input_file.h>
#include <seiche/scene/tank_body.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    const char *const free_path = "Tank motion/Free";

    template <int dim>
    std::string
    names_of_directions()
    {
      std::string names;
      for (unsigned int d = 0; d < TankDirection<dim>::n_all; ++d)
        names += (names.empty() ? "" : ", ") +
                 std::string(TankDirection<dim>{d}.name());
      return names;
    }
  } // namespace

  template <int dim>
  const char *
  TankDirection<dim>::name() const
  {
    static const std::array<const char *, 3> names_2d = {
      {"x", "y", "rotation"}};
    static const std::array<const char *, 6> names_3d = {
      {"x", "y", "z", "roll", "pitch", "yaw"}};
    if constexpr (dim == 2)
      return names_2d[number];
    else
      return names_3d[number];
  }

  template <int dim>
  std::array<std::string, 2>
  TankDirection<dim>::columns() const
  {
    if (!is_angle())
      return {{fmt::format("tank velocity {} [m/s]", name()),
               fmt::format("fluid force on tank {} [N]", name())}};
    const std::string which = dim == 2 ? "" : std::string(name()) + " ";
    return {{fmt::format("tank {}rate [rad/s]", which),
             fmt::format("fluid moment on tank {}[N m]", which)}};
  }

  template <int dim>
  void
  TankBodyParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    const Patterns::Anything anything;
    prm.add_parameter("Free",
                      free,
                      "Directions in which the fluid moves the tank, beside "
                      "the motion that is given: any of " +
                        names_of_directions<dim>() +
                        (dim == 2 ? "" : ", one angle at most") +
                        ", separated by commas. A tank that may turn and be "
                        "displaced has its centre of mass at Centre; empty: "
                        "none.",
                      anything);
    prm.add_parameter("Inertia",
                      inertia,
                      "Of the tank without fluid, for each direction of Free: "
                      "mass [kg] or moment of inertia about Centre [kg m^2], "
                      "in 2D per metre; expressions of t, separated by \";\".",
                      anything);
    prm.add_parameter("Load",
                      load,
                      "On the tank without that of the fluid, for each "
                      "direction of Free: force [N] or moment about Centre "
                      "[N m], in 2D per metre, of springs, dampers, weight; "
                      "expressions of x, the displacement or angle in this "
                      "direction, y, its rate, and t, separated by \";\". "
                      "Empty: none.",
                      anything);
    prm.add_parameter("Start",
                      start,
                      "Displacement or angle of each direction of Free at the "
                      "start; empty: 0. [m, rad]",
                      anything);
    prm.add_parameter("Start rate",
                      start_rate,
                      "The same of its rate. [m/s, rad/s]",
                      anything);
  }

  template <int dim>
  void
  TankBodyParameters<dim>::check(const InputFile &input) const
  {
    for (const char *const entry : {"Inertia", "Load", "Start", "Start rate"})
      input.read_only_if(any(), std::string("Tank motion/") + entry, free_path);
    if (any())
      input.cites("broyden1965");
  }

  template <int dim>
  std::vector<TankDirection<dim>>
  TankBodyParameters<dim>::directions(const InputFile &input) const
  {
    std::vector<TankDirection<dim>> result;
    unsigned int                    n_angles = 0;
    for (const std::string &name : Utilities::split_string_list(free))
      {
        TankDirection<dim> direction{0};
        while (direction.number < direction.n_all && name != direction.name())
          ++direction.number;
        input.require(direction.number < direction.n_all,
                      free_path,
                      "there is no direction \"" + name + "\"; allowed are " +
                        names_of_directions<dim>() + ".");
        input.require(std::none_of(result.begin(),
                                   result.end(),
                                   [&](const auto &other) {
                                     return other.number == direction.number;
                                   }),
                      free_path,
                      "\"" + name + "\" is named twice; name it once.");
        n_angles += direction.is_angle();
        result.push_back(direction);
      }
    input.require(n_angles <= 1,
                  free_path,
                  "a tank that turns freely about two axes is not possible; "
                  "name one angle.");
    return result;
  }

  template <int dim>
  bool
  TankBodyParameters<dim>::turns() const
  {
    const auto names = Utilities::split_string_list(free);
    return std::any_of(names.begin(), names.end(), [](const auto &name) {
      TankDirection<dim> angle{dim};
      while (angle.number < angle.n_all && name != angle.name())
        ++angle.number;
      return angle.number < angle.n_all;
    });
  }

  template struct TankDirection<2>;
  template struct TankDirection<3>;
  template struct TankBodyParameters<2>;
  template struct TankBodyParameters<3>;
} // namespace seiche
