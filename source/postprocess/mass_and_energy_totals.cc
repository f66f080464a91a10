// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/mass_and_energy.h>
#include <seiche/utilities/over_ranks.h>

#include <limits>

// The part of MassAndEnergy that sums up over the points.
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
  } // namespace

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

  template MassAndEnergy<2>::Totals
  MassAndEnergy<2>::sum_up(const StepView<2> &) const;
  template MassAndEnergy<3>::Totals
  MassAndEnergy<3>::sum_up(const StepView<3> &) const;
} // namespace seiche
