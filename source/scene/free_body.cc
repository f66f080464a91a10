// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/expression_text.h>
#include <seiche/scene/free_body.h>
#include <seiche/scene/sample_times.h>
#include <seiche/utilities/state_archive.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace seiche
{
  using namespace dealii;

  namespace
  {
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
    std::vector<typename FreeBody<dim>::Freedom>
    make_freedoms(const FreeBodyParameters<dim> &parameters,
                  const InputFile               &input)
    {
      const auto        directions = parameters.directions(input);
      const std::size_t n          = directions.size();
      const auto        places =
        read_numbers<dim>(input, parameters.path("Start"), parameters.start, n);
      const auto rates = read_numbers<dim>(input,
                                           parameters.path("Start rate"),
                                           parameters.start_rate,
                                           n);
      std::vector<typename FreeBody<dim>::Freedom> result(n);
      for (std::size_t i = 0; i < n; ++i)
        {
          result[i].direction = directions[i];
          result[i].place     = places[i];
          result[i].rate      = rates[i];
        }
      input.require(!parameters.inertia.empty(),
                    parameters.path("Inertia"),
                    "the " + parameters.what +
                      "'s mass, or moment of inertia, is needed in each "
                      "direction of \"Free\".");
      require_without(input,
                      parameters.path("Inertia"),
                      parameters.inertia,
                      {"x", "y", "z"},
                      "an expression of t alone is needed.");
      require_without(input,
                      parameters.path("Load"),
                      parameters.load,
                      {"z"},
                      "z does not exist here: x is the displacement or angle "
                      "in this direction, y its rate.");
      return result;
    }

    /// What the expression of a load knows as x and y.
    template <int dim>
    Point<dim>
    state_of(const double place, const double rate)
    {
      Point<dim> state;
      state[0] = place;
      state[1] = rate;
      return state;
    }
  } // namespace

  template <int dim>
  FreeBody<dim>::FreeBody(const FreeBodyParameters<dim> &parameters,
                          const InputFile               &input,
                          const double                   end_time)
    : list(make_freedoms(parameters, input))
    , inertias(input,
               parameters.path("Inertia"),
               parameters.inertia,
               list.size())
    , loads(input,
            parameters.path("Load"),
            parameters.load.empty() ? no_loads(list.size()) : parameters.load,
            list.size(),
            state_of<dim>(list.front().place, list.front().rate))
  {
    for (const double t : sample_times(end_time))
      for (unsigned int i = 0; i < list.size(); ++i)
        input.require(inertias.value(Point<dim>(), t, i) > 0.,
                      parameters.path("Inertia"),
                      "must be greater than zero at all times.");
    loads.check_until(end_time);
    std::array<MotionJet, n_rotations<dim>> angles;
    unsigned int                            n_angles = 0;
    for (const Freedom &freedom : list)
      if (freedom.direction.is_angle())
        {
          angles[freedom.direction.number - dim].value = freedom.place;
          ++n_angles;
        }
    is_tumbling = n_angles > 1;
    turned      = rotation_jet<dim>(angles).value;
  }

  template <int dim>
  MotionJet
  FreeBody<dim>::jet(const unsigned int direction, const double time) const
  {
    for (const Freedom &freedom : list)
      if (freedom.direction.number == direction)
        {
          const double dt = std::clamp(time - start, 0., size);
          const double a  = freedom.acceleration;
          const double start_place =
            restarts_in_steps(freedom) ? 0. : freedom.place;
          return {start_place + dt * (freedom.rate + 0.5 * dt * a),
                  freedom.rate + dt * a,
                  a};
        }
    return {};
  }

  template <int dim>
  void
  FreeBody<dim>::begin(const double time, const double step)
  {
    start = time;
    size  = step;
    for (Freedom &freedom : list)
      freedom.acceleration = freedom.previous;
    ++changes;
  }

  template <int dim>
  void
  FreeBody<dim>::set_acceleration(const unsigned int freedom,
                                  const double       acceleration)
  {
    list[freedom].acceleration = acceleration;
    ++changes;
  }

  template <int dim>
  double
  FreeBody<dim>::inertia(const unsigned int freedom) const
  {
    return inertias.value(Point<dim>(), start + 0.5 * size, freedom);
  }

  template <int dim>
  double
  FreeBody<dim>::load(const unsigned int freedom) const
  {
    const Freedom  &own = list[freedom];
    const MotionJet end = jet(own.direction.number, start + size);
    const double gone   = end.value - (restarts_in_steps(own) ? 0. : own.place);
    return loads.value(state_of<dim>(own.place + 0.5 * gone,
                                     0.5 * (own.rate + end.first)),
                       start + 0.5 * size,
                       freedom);
  }

  template <int dim>
  void
  FreeBody<dim>::accept()
  {
    const MatrixJet<dim> turn = turn_until(start + size);
    for (Freedom &freedom : list)
      {
        const MotionJet end = jet(freedom.direction.number, start + size);
        freedom.place       = end.value;
        freedom.rate        = end.first;
        freedom.previous    = freedom.acceleration;
      }
    if (is_tumbling)
      set_turn(turn.value * turned,
               axial<dim>(turn.first * transpose(turn.value)));
    start += size;
    size = 0.;
    ++changes;
  }

  template <int dim>
  void
  FreeBody<dim>::save_or_load(StateArchive &archive)
  {
    archive("time", start);
    for (Freedom &freedom : list)
      archive.section(freedom.direction.name(), [&]() {
        archive("place", freedom.place);
        archive("rate", freedom.rate);
        archive("acceleration", freedom.acceleration);
        archive("previous acceleration", freedom.previous);
        archive("fluid", freedom.fluid);
        archive("stop", freedom.stop);
      });
    for (unsigned int i = 0; is_tumbling && i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        archive("turned " + std::to_string(i) + std::to_string(j),
                turned[i][j]);
    ++changes;
  }

  template class FreeBody<2>;
  template class FreeBody<3>;
} // namespace seiche
