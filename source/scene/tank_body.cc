// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/expression_text.h>
#include <seiche/scene/sample_times.h>
#include <seiche/scene/tank_body.h>
#include <seiche/utilities/state_archive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    const char *const free_path    = "Tank motion/Free";
    const char *const inertia_path = "Tank motion/Inertia";
    const char *const load_path    = "Tank motion/Load";

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

    std::string
    no_loads(const std::size_t n)
    {
      std::string text = "0";
      for (std::size_t i = 1; i < n; ++i)
        text += "; 0";
      return text;
    }

    /// One number for each direction; none given: zeros.
    template <int dim>
    std::vector<double>
    read_numbers(const InputFile   &input,
                 const std::string &path,
                 const std::string &text,
                 const std::size_t  n)
    {
      if (text.empty())
        return std::vector<double>(n, 0.);
      std::vector<double> result = entry_values::numbers(input, path, text);
      input.require(result.size() == n,
                    path,
                    fmt::format("{} number(s) given; one is needed for each "
                                "of the {} directions of \"Free\".",
                                result.size(),
                                n));
      return result;
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
      return name.size() > 1; // x, y, z are the others
    });
  }

  namespace
  {
    /// InputError if an expression has one of these variables.
    void
    require_without(const InputFile                &input,
                    const std::string              &path,
                    const std::string              &text,
                    const std::vector<std::string> &variables,
                    const std::string              &why)
    {
      std::set<std::string> names;
      (void)problem_in_expression(text, names);
      for (const std::string &variable : variables)
        input.require(names.count(variable) == 0, path, why);
    }

    /// The free directions at the start.
    template <int dim>
    std::vector<typename TankBody<dim>::Freedom>
    make_freedoms(const TankBodyParameters<dim> &parameters,
                  const InputFile               &input)
    {
      const auto        directions = parameters.directions(input);
      const std::size_t n          = directions.size();
      const auto        places =
        read_numbers<dim>(input, "Tank motion/Start", parameters.start, n);
      const auto rates = read_numbers<dim>(input,
                                           "Tank motion/Start rate",
                                           parameters.start_rate,
                                           n);
      std::vector<typename TankBody<dim>::Freedom> result(n);
      for (std::size_t i = 0; i < n; ++i)
        {
          result[i].direction = directions[i];
          result[i].place     = places[i];
          result[i].rate      = rates[i];
        }
      input.require(!parameters.inertia.empty(),
                    inertia_path,
                    "the tank's mass, or moment of inertia, is needed in each "
                    "direction of \"Free\".");
      require_without(input,
                      inertia_path,
                      parameters.inertia,
                      {"x", "y", "z"},
                      "an expression of t alone is needed.");
      require_without(input,
                      load_path,
                      parameters.load,
                      {"z"},
                      "z does not exist here: x is the displacement or angle "
                      "in this direction, y its rate.");
      return result;
    }

    /// What expressions of loads are tried with.
    template <int dim>
    Point<dim>
    state_of(const typename TankBody<dim>::Freedom &freedom)
    {
      Point<dim> state;
      state[0] = freedom.place;
      state[1] = freedom.rate;
      return state;
    }
  } // namespace

  template <int dim>
  TankBody<dim>::TankBody(const TankBodyParameters<dim> &parameters,
                          const InputFile               &input,
                          const double                   end_time)
    : list(make_freedoms(parameters, input))
    , inertias(input, inertia_path, parameters.inertia, list.size())
    , loads(input,
            load_path,
            parameters.load.empty() ? no_loads(list.size()) : parameters.load,
            list.size(),
            state_of<dim>(list.front()))
  {
    for (const double t : sample_times(end_time))
      for (unsigned int i = 0; i < list.size(); ++i)
        input.require(inertias.value(Point<dim>(), t, i) > 0.,
                      inertia_path,
                      "must be greater than zero at all times.");
    loads.check_until(end_time);
  }

  template <int dim>
  MotionJet
  TankBody<dim>::jet(const unsigned int direction, const double time) const
  {
    for (const Freedom &freedom : list)
      if (freedom.direction.number == direction)
        {
          const double dt = std::clamp(time - start, 0., size);
          const double a  = freedom.acceleration;
          return {freedom.place + dt * (freedom.rate + 0.5 * dt * a),
                  freedom.rate + dt * a,
                  a};
        }
    return {};
  }

  template <int dim>
  void
  TankBody<dim>::begin(const double time, const double step)
  {
    start = time;
    size  = step;
    for (Freedom &freedom : list)
      freedom.acceleration = freedom.previous;
    ++changes;
  }

  template <int dim>
  void
  TankBody<dim>::set_acceleration(const unsigned int freedom,
                                  const double       acceleration)
  {
    list[freedom].acceleration = acceleration;
    ++changes;
  }

  template <int dim>
  double
  TankBody<dim>::inertia(const unsigned int freedom) const
  {
    return inertias.value(Point<dim>(), start + 0.5 * size, freedom);
  }

  template <int dim>
  double
  TankBody<dim>::load(const unsigned int freedom) const
  {
    const Freedom  &own = list[freedom];
    const MotionJet end = jet(own.direction.number, start + size);
    Point<dim>      state;
    state[0] = 0.5 * (own.place + end.value);
    state[1] = 0.5 * (own.rate + end.first);
    return loads.value(state, start + 0.5 * size, freedom);
  }

  template <int dim>
  void
  TankBody<dim>::accept()
  {
    for (Freedom &freedom : list)
      {
        const MotionJet end = jet(freedom.direction.number, start + size);
        freedom.place       = end.value;
        freedom.rate        = end.first;
        freedom.previous    = freedom.acceleration;
      }
    start += size;
    size = 0.;
    ++changes;
  }

  template <int dim>
  void
  TankBody<dim>::save_or_load(StateArchive &archive)
  {
    archive("time", start);
    for (Freedom &freedom : list)
      archive.section(freedom.direction.name(), [&]() {
        archive("place", freedom.place);
        archive("rate", freedom.rate);
        archive("acceleration", freedom.acceleration);
        archive("previous acceleration", freedom.previous);
        archive("fluid", freedom.fluid);
      });
    ++changes;
  }

  template struct TankDirection<2>;
  template struct TankDirection<3>;
  template struct TankBodyParameters<2>;
  template struct TankBodyParameters<3>;
  template class TankBody<2>;
  template class TankBody<3>;
} // namespace seiche
