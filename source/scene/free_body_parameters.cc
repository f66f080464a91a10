// SPDX-License-Identifier: LGPL-2.1-or-later
// The entries of a body that the fluid moves, and the names of its directions.
#include <seiche/parameters/input_file.h>
#include <seiche/scene/free_body.h>

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
    template <int dim>
    std::string
    names_of_directions()
    {
      std::string names;
      for (unsigned int d = 0; d < BodyDirection<dim>::n_all; ++d)
        names += (names.empty() ? "" : ", ") +
                 std::string(BodyDirection<dim>{d}.name());
      return names;
    }
  } // namespace

  template <int dim>
  const char *
  BodyDirection<dim>::name() const
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
  std::string
  BodyDirection<dim>::column_of_place(const std::string &body) const
  {
    return is_angle() ?
             fmt::format("{} {} [rad]", body, dim == 2 ? "angle" : name()) :
             fmt::format("{} displacement {} [m]", body, name());
  }

  template <int dim>
  std::array<std::string, 2>
  BodyDirection<dim>::columns(const std::string &body) const
  {
    if (!is_angle())
      return {{fmt::format("{} velocity {} [m/s]", body, name()),
               fmt::format("fluid force on {} {} [N]", body, name())}};
    const std::string which = dim == 2 ? "" : std::string(name()) + " ";
    return {{fmt::format("{} {}rate [rad/s]", body, which),
             fmt::format("fluid moment on {} {}[N m]", body, which)}};
  }

  template <int dim>
  std::string
  BodyDirection<dim>::column_of_stop(const std::string &body) const
  {
    if (!is_angle())
      return fmt::format("stop force on {} {} [N]", body, name());
    return fmt::format("stop moment on {}{} [N m]",
                       body,
                       dim == 2 ? "" : std::string(" ") + name());
  }

  template <int dim>
  void
  FreeBodyParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    const Patterns::Anything anything;
    prm.add_parameter("Free",
                      free,
                      "Directions in which the fluid moves the " + what +
                        ", beside the motion that is given: any of " +
                        names_of_directions<dim>() +
                        (dim == 2   ? "" :
                         may_tumble ? ", one angle or all three, then with "
                                      "rates about the axes of space" :
                                      ", one angle at most") +
                        ", separated by commas. A " + what +
                        " that may turn and be displaced has its centre of "
                        "mass at " +
                        centre + "; empty: none.",
                      anything);
    prm.add_parameter("Inertia",
                      inertia,
                      "Of the " + what +
                        " without fluid, for each direction of Free: "
                        "mass [kg] or moment of inertia about " +
                        centre +
                        " [kg m^2], "
                        "in 2D per metre; expressions of t, separated by "
                        "\";\".",
                      anything);
    prm.add_parameter("Load",
                      load,
                      "On the " + what +
                        " without that of the fluid, for each "
                        "direction of Free: force [N] or moment about " +
                        centre +
                        " [N m], in 2D per metre, of springs, dampers" +
                        of_weight +
                        "; expressions of x, the displacement or angle in this "
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
  FreeBodyParameters<dim>::check(const InputFile &input) const
  {
    for (const char *const entry : {"Inertia", "Load", "Start", "Start rate"})
      input.read_only_if(any(), path(entry), path("Free"));
    if (any())
      input.cites("broyden1965");
  }

  template <int dim>
  std::vector<BodyDirection<dim>>
  FreeBodyParameters<dim>::directions(const InputFile &input) const
  {
    std::vector<BodyDirection<dim>> result;
    unsigned int                    n_angles = 0;
    for (const std::string &name : Utilities::split_string_list(free))
      {
        BodyDirection<dim> direction{0};
        while (direction.number < direction.n_all && name != direction.name())
          ++direction.number;
        input.require(direction.number < direction.n_all,
                      path("Free"),
                      "there is no direction \"" + name + "\"; allowed are " +
                        names_of_directions<dim>() + ".");
        input.require(std::none_of(result.begin(),
                                   result.end(),
                                   [&](const auto &other) {
                                     return other.number == direction.number;
                                   }),
                      path("Free"),
                      "\"" + name + "\" is named twice; name it once.");
        n_angles += direction.is_angle();
        result.push_back(direction);
      }
    input.require(n_angles <= 1 || (may_tumble && n_angles == n_rotations<dim>),
                  path("Free"),
                  "a " + what +
                    " that turns freely about two axes is not possible; "
                    "name one angle" +
                    (may_tumble ? ", or all three." : "."));
    return result;
  }

  template <int dim>
  bool
  FreeBodyParameters<dim>::turns() const
  {
    const auto names = Utilities::split_string_list(free);
    return std::any_of(names.begin(), names.end(), [](const auto &name) {
      BodyDirection<dim> angle{dim};
      while (angle.number < angle.n_all && name != angle.name())
        ++angle.number;
      return angle.number < angle.n_all;
    });
  }

  template struct BodyDirection<2>;
  template struct BodyDirection<3>;
  template struct FreeBodyParameters<2>;
  template struct FreeBodyParameters<3>;
} // namespace seiche
