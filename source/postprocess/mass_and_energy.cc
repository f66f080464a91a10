// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/mass_and_energy.h>
#include <seiche/utilities/axis_names.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    nlohmann::ordered_json
    number_or_null(const double value)
    {
      return std::isfinite(value) ? nlohmann::ordered_json(value) :
                                    nlohmann::ordered_json(nullptr);
    }

    constexpr double round_off = 1e-12; // of a gravity that was turned and back
    constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  } // namespace

  template <int dim>
  MassAndEnergy<dim>::MassAndEnergy(const BackgroundGrid<dim> &background_grid,
                                    const TankRecord<dim>     *tank_record)
    : grid(background_grid)
    , tank(tank_record)
  {}

  template <int dim>
  Tensor<1, dim>
  MassAndEnergy<dim>::zero_of_potential(const StepView<dim> &view)
  {
    // by gravity in the laboratory, which stays: the tank's may turn past an
    // axis
    const Tensor<1, dim> gravity =
      view.tank != nullptr ? view.tank->rotation * view.gravity : view.gravity;
    const auto    &parameters = view.occupancy.locator.grid.parameters;
    Tensor<1, dim> lowest;
    for (unsigned int d = 0; d < dim; ++d)
      lowest[d] = gravity[d] > round_off * gravity.norm() ?
                    parameters.upper_corner[d] :
                    parameters.lower_corner[d];
    return lowest;
  }

  template <int dim>
  std::vector<std::string>
  MassAndEnergy<dim>::columns()
  {
    std::vector<std::string> names = {"points",
                                      "mass [kg]",
                                      "volume_relative_change"};
    for (unsigned int d = 0; d < dim; ++d)
      names.push_back(std::string("momentum ") + axis_names[d] + " [kg m/s]");
    for (unsigned int d = 3 - n_rotations; d < 3; ++d)
      names.push_back(std::string("angular momentum ") + axis_names[d] +
                      " [kg m^2/s]");
    for (const char *name : {"kinetic energy [J]",
                             "potential energy [J]",
                             "relative_energy",
                             "speed_max [m/s]",
                             "volume_ratio_min",
                             "volume_ratio_max",
                             "overfull_fraction",
                             "outflow_points"})
      names.emplace_back(name);
    return names;
  }

  template <int dim>
  void
  MassAndEnergy<dim>::execute(const StepView<dim> &view,
                              StatisticsTable     &statistics)
  {
    now = sum_up(view);
    if (!started)
      {
        start          = now;
        energy_minimum = energy();
        started        = true;
      }
    energy_minimum = std::min(energy_minimum, energy());
    energy_rise    = std::max(energy_rise, energy() - energy_minimum);

    const double overfull = view.fill.overfull_fraction();
    overfull_maximum      = std::max(overfull_maximum, overfull);
    overfull_sum += overfull;
    ++n_rows;

    std::vector<double> values = {static_cast<double>(now.points),
                                  now.mass,
                                  volume_change()};
    values.insert(values.end(), now.momentum.begin(), now.momentum.end());
    values.insert(values.end(),
                  now.angular_momentum.begin(),
                  now.angular_momentum.end());
    for (const double value : {now.kinetic,
                               now.potential,
                               relative_energy(),
                               now.speed_max,
                               now.volume_ratio_min,
                               now.volume_ratio_max,
                               overfull,
                               static_cast<double>(now.outflow_points)})
      values.push_back(value);
    static const std::vector<std::string> names = columns();
    for (unsigned int c = 0; c < names.size(); ++c)
      statistics.set(names[c], values[c]);
  }

  template <int dim>
  void
  MassAndEnergy<dim>::finish(const StatisticsTable  &statistics,
                             nlohmann::ordered_json &summary)
  {
    if (!started)
      return;
    std::vector<double> momentum_change(dim);
    for (unsigned int d = 0; d < dim; ++d)
      momentum_change[d] = now.momentum[d] - start.momentum[d];

    double change = 0., size = 0.;
    for (unsigned int r = 0; r < n_rotations; ++r)
      {
        change +=
          std::pow(now.angular_momentum[r] - start.angular_momentum[r], 2);
        size += std::pow(start.angular_momentum[r], 2);
      }
    // zero up to the rounding of the velocities that were typed in
    const double scale =
      start.mass * start.speed_max *
      grid.parameters.lower_corner.distance(grid.parameters.upper_corner);
    const bool rotates = std::sqrt(size) > 1e-10 * scale;
    const bool moves   = start.energy() > 0.;

    nlohmann::ordered_json &ledger = summary["ledger"];
    ledger["mass_relative_change"] =
      number_or_null((now.mass + now.outflow_mass) / start.mass - 1.);
    ledger["volume_relative_change"] = number_or_null(volume_change());
    ledger["linear_momentum_change"] = momentum_change;
    ledger["angular_momentum_relative_change"] =
      number_or_null(rotates ? std::sqrt(change / size) : undefined);
    ledger["energy_initial"] = number_or_null(start.energy());
    ledger["energy_final"]   = number_or_null(now.energy());
    ledger["energy_max_relative_gain"] =
      number_or_null(moves ? energy_rise / start.energy() : undefined);
    // since the start: made by splitting, gone by merging (PointControl)
    const auto count = [&statistics](const std::string &name) {
      return statistics.has(name) ?
               static_cast<std::int64_t>(statistics.last(name)) :
               0;
    };
    ledger["lost_points"] =
      static_cast<std::int64_t>(start.points) + count("points split [-]") -
      count("points merged [-]") - static_cast<std::int64_t>(now.points) -
      static_cast<std::int64_t>(now.outflow_points);
    ledger["outflow_points"]         = now.outflow_points;
    ledger["overfull_fraction"]      = number_or_null(overfull_maximum);
    ledger["overfull_fraction_mean"] = number_or_null(overfull_sum / n_rows);
  }

  template <int dim>
  void
  MassAndEnergy<dim>::Totals::save_or_load(StateArchive &archive)
  {
    archive("mass", mass);
    archive("volume", volume);
    archive("initial volume", initial_volume);
    archive("kinetic", kinetic);
    archive("potential", potential);
    archive("momentum", momentum);
    archive("angular momentum", angular_momentum);
    archive("speed max", speed_max);
    archive("volume ratio min", volume_ratio_min);
    archive("volume ratio max", volume_ratio_max);
    archive("outflow mass", outflow_mass);
    archive("points", points);
    archive("outflow points", outflow_points);
  }

  template <int dim>
  void
  MassAndEnergy<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("ledger", [&]() {
      archive.section("start", [&]() { start.save_or_load(archive); });
      archive.section("now", [&]() { now.save_or_load(archive); });
      archive("started", started);
      archive("energy minimum", energy_minimum);
      archive("energy rise", energy_rise);
      archive("overfull maximum", overfull_maximum);
      archive("overfull sum", overfull_sum);
      archive("rows", n_rows);
    });
  }

  template <int dim>
  double
  MassAndEnergy<dim>::relative_energy_gain() const
  {
    return start.energy() > 0. ? energy_rise / start.energy() : 0.;
  }

  template <int dim>
  double
  MassAndEnergy<dim>::relative_energy() const
  {
    return start.energy() > 0. ? energy() / start.energy() : undefined;
  }

  template class MassAndEnergy<2>;
  template class MassAndEnergy<3>;
} // namespace seiche
