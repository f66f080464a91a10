// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/mass_and_energy.h>
#include <seiche/utilities/axis_names.h>
#include <seiche/utilities/over_ranks.h>

#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Quantities summed over the points: five scalars, then momentum and
    /// angular momentum.
    enum Summand : unsigned int
    {
      mass,
      volume,
      initial_volume,
      kinetic,
      potential,
      vectors
    };

    constexpr unsigned int n_lanes    = 8;
    constexpr unsigned int block_size = 512; // points, a multiple of n_lanes

    template <int dim>
    constexpr unsigned int n_sums = vectors + dim + (dim == 2 ? 1 : 3);

    template <int dim>
    using Lanes = std::array<std::array<double, n_lanes>, n_sums<dim>>;

    /// The columns that the ledger reads, as plain arrays.
    template <int dim>
    struct Columns
    {
      std::array<const double *, dim> x, v;
      const double                   *m, *ratio, *v0;
      Tensor<1, dim>                  gravity; // [m/s^2]
      Tensor<1, dim>                  lowest;  // corner of zero potential

      explicit Columns(const StepView<dim> &view)
        : m(view.points.data(PointColumn::mass))
        , ratio(view.points.data(PointColumn::volume_ratio))
        , v0(view.points.data(PointColumn::initial_volume))
        , gravity(view.gravity)
        , lowest(MassAndEnergy<dim>::zero_of_potential(view))
      {
        for (unsigned int d = 0; d < dim; ++d)
          {
            x[d] = view.points.data(PointColumn::position, d);
            v[d] = view.points.data(PointColumn::velocity, d);
            if (view.occupancy.locator.grid.parameters.is_periodic(d))
              gravity[d] = 0.; // a force along it has no potential
          }
      }
    };

    /// Add point @p i to lane @p l.
    template <int dim>
    inline void
    add_point(const Columns<dim> &c,
              const std::size_t   i,
              const unsigned int  l,
              Lanes<dim>         &sums)
    {
      double square = 0., work = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          square += c.v[d][i] * c.v[d][i];
          work -= c.gravity[d] * (c.x[d][i] - c.lowest[d]);
          sums[vectors + d][l] += c.m[i] * c.v[d][i];
        }
      sums[mass][l] += c.m[i];
      sums[volume][l] += c.ratio[i] * c.v0[i];
      sums[initial_volume][l] += c.v0[i];
      sums[kinetic][l] += 0.5 * c.m[i] * square;
      sums[potential][l] += c.m[i] * work;
      if constexpr (dim == 2)
        sums[vectors + dim][l] +=
          c.m[i] * (c.x[0][i] * c.v[1][i] - c.x[1][i] * c.v[0][i]);
      else
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int e = (d + 1) % dim, f = (d + 2) % dim;
            sums[vectors + dim + d][l] +=
              c.m[i] * (c.x[e][i] * c.v[f][i] - c.x[f][i] * c.v[e][i]);
          }
    }

    /// Sums of the block [begin, end) by lanes, the lanes added in pairs.
    template <int dim>
    std::array<double, n_sums<dim>>
    sum_block(const Columns<dim> &columns,
              const std::size_t   begin,
              const std::size_t   end)
    {
      Lanes<dim>  lanes{};
      std::size_t i = begin;
      for (; i + n_lanes <= end; i += n_lanes)
        for (unsigned int l = 0; l < n_lanes; ++l)
          add_point(columns, i + l, l, lanes);
      for (unsigned int l = 0; i < end; ++i, ++l)
        add_point(columns, i, l, lanes);

      std::array<double, n_sums<dim>> result;
      for (unsigned int s = 0; s < n_sums<dim>; ++s)
        {
          for (unsigned int width = n_lanes / 2; width > 0; width /= 2)
            for (unsigned int l = 0; l < width; ++l)
              lanes[s][l] += lanes[s][l + width];
          result[s] = lanes[s][0];
        }
      return result;
    }

    /// Sum with the rounding errors kept aside (Neumaier 1974).
    struct CompensatedSum
    {
      double sum = 0., correction = 0.;

      void
      add(const double value)
      {
        const double total = sum + value;
        correction += std::abs(sum) >= std::abs(value) ? (sum - total) + value :
                                                         (value - total) + sum;
        sum = total;
      }
    };

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
  typename MassAndEnergy<dim>::Totals
  MassAndEnergy<dim>::sum_up(const StepView<dim> &view) const
  {
    const Columns<dim>                      columns(view);
    const std::size_t                       n = view.points.size();
    std::array<CompensatedSum, n_sums<dim>> sums;
    for (std::size_t begin = 0; begin < n; begin += block_size)
      {
        const auto block =
          sum_block(columns,
                    begin,
                    std::min<std::size_t>(begin + block_size, n));
        for (unsigned int s = 0; s < n_sums<dim>; ++s)
          sums[s].add(block[s]);
      }

    // largest |v|^2, J and -J
    std::array<double, 3> extremes = {{0.,
                                       -std::numeric_limits<double>::max(),
                                       -std::numeric_limits<double>::max()}};
    for (std::size_t i = 0; i < n; ++i)
      {
        double square = 0.;
        for (unsigned int d = 0; d < dim; ++d)
          square += columns.v[d][i] * columns.v[d][i];
        extremes[0] = std::max(extremes[0], square);
        extremes[1] = std::max(extremes[1], columns.ratio[i]);
        extremes[2] = std::max(extremes[2], -columns.ratio[i]);
      }

    const MPI_Comm                  communicator = view.points.communicator;
    std::array<double, n_sums<dim>> global;
    for (unsigned int s = 0; s < n_sums<dim>; ++s)
      global[s] = sums[s].sum + sums[s].correction;
    sum_over_ranks(global, communicator);
    maximum_over_ranks(extremes, communicator);

    Totals totals;
    totals.mass           = global[mass];
    totals.volume         = global[volume];
    totals.initial_volume = global[initial_volume];
    totals.kinetic        = global[kinetic];
    totals.potential      = global[potential];
    std::copy_n(global.begin() + vectors, dim, totals.momentum.begin());
    std::copy_n(global.begin() + vectors + dim,
                n_rotations,
                totals.angular_momentum.begin());
    totals.speed_max        = std::sqrt(extremes[0]);
    totals.volume_ratio_max = extremes[1];
    totals.volume_ratio_min = -extremes[2];
    totals.outflow_mass     = view.points.outflow.mass;
    totals.points           = view.points.n_global();
    totals.outflow_points   = view.points.outflow.points;
    return totals;
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
