// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/reseeding.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Have they equal values in the columns that must be the same?
    template <int dim>
    bool
    are_alike(const PointCloud<dim> &points,
              const std::size_t      a,
              const std::size_t      b)
    {
      return std::all_of(point_column_table.begin(),
                         point_column_table.end(),
                         [&](const PointColumnInfo &info) {
                           return info.merge != MergeRule::same ||
                                  !points.has(info.column) ||
                                  points.data(info.column)[a] ==
                                    points.data(info.column)[b];
                         });
    }
    /// A column of two points that become one; the shares are those of the
    /// other point.
    void
    merge_values(const MergeRule rule,
                 const double    other,
                 const double    mass_share,
                 const double    volume_share,
                 double         &value)
    {
      switch (rule)
        {
          case MergeRule::by_mass:
            value += mass_share * (other - value);
            break;
          case MergeRule::by_volume:
            value += volume_share * (other - value);
            break;
          case MergeRule::sum:
            value += other;
            break;
          case MergeRule::same:
            break;
        }
    }
  } // namespace

  template <int dim>
  Reseeding<dim>::Reseeding(const Fill<dim>   &grid_fill,
                            const unsigned int fewest_points,
                            const unsigned int most_points)
    : fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , fewest(fewest_points)
    , most(most_points)
  {}

  template <int dim>
  std::size_t
  Reseeding<dim>::size_of(const unsigned int cell) const
  {
    std::size_t result = 1;
    for (unsigned int d = 0; d < dim; ++d)
      result *= occupancy.locator.lattice.size(cell);
    return result;
  }

  template <int dim>
  std::uint64_t
  Reseeding<dim>::merge(PointCloud<dim> &points) const
  {
    std::vector<std::size_t> dropped, alive;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const std::size_t limit = most * size_of(cell);
        if (fill.is_cut(cell) || points.n_points_in(cell) <= limit)
          continue;
        alive.clear();
        for (const std::size_t p : points.points_in(cell))
          alive.push_back(p);
        while (alive.size() > limit)
          if (const auto p = merge_pair(points, alive))
            dropped.push_back(*p);
      }
    std::sort(dropped.begin(), dropped.end());
    points.remove(dropped);
    return dropped.size();
  }

  template <int dim>
  std::optional<std::size_t>
  Reseeding<dim>::merge_pair(PointCloud<dim>          &points,
                             std::vector<std::size_t> &alive) const
  {
    const double *mass   = points.data(PointColumn::mass);
    const double *volume = points.data(PointColumn::initial_volume);

    // the first in the order of ids among equals
    const auto  lightest = *std::min_element(alive.begin(),
                                            alive.end(),
                                            [&](const auto a, const auto b) {
                                              return volume[a] < volume[b];
                                            });
    std::size_t nearest  = lightest;
    double      least    = std::numeric_limits<double>::max();
    for (const std::size_t p : alive)
      {
        const double distance =
          points.position(p).distance_square(points.position(lightest));
        if (p != lightest && distance < least && are_alike(points, p, lightest))
          {
            least   = distance;
            nearest = p;
          }
      }
    if (nearest == lightest) // it stays as it is
      {
        alive.erase(std::find(alive.begin(), alive.end(), lightest));
        return {};
      }

    // the older one stays, so that a tracked point lives long
    const std::size_t keep       = std::min(lightest, nearest);
    const std::size_t drop       = std::max(lightest, nearest);
    const double      mass_share = mass[drop] / (mass[keep] + mass[drop]);
    const double volume_share    = volume[drop] / (volume[keep] + volume[drop]);
    for (const PointColumnInfo &info : point_column_table)
      if (points.has(info.column))
        for (unsigned int c = 0; c < n_components(info.column, dim); ++c)
          merge_values(info.merge,
                       points.data(info.column, c)[drop],
                       mass_share,
                       volume_share,
                       points.data(info.column, c)[keep]);
    alive.erase(std::find(alive.begin(), alive.end(), drop));
    return drop;
  }

  template <int dim>
  std::uint64_t
  Reseeding<dim>::split(PointCloud<dim> &points, std::uint64_t &next_id) const
  {
    std::vector<std::pair<std::size_t, Tensor<1, dim>>> chosen;
    for (const unsigned int cell : occupancy.cells.occupied())
      if (!fill.is_cut(cell) &&
          points.n_points_in(cell) < fewest * size_of(cell))
        choose(cell, points, chosen);

    std::vector<std::uint64_t> parents;
    for (const auto &choice : chosen)
      parents.push_back(points.ids()[choice.first]);
    std::vector<std::uint64_t> all_parents;
    for (const auto &own :
         Utilities::MPI::all_gather(points.communicator, parents))
      all_parents.insert(all_parents.end(), own.begin(), own.end());
    std::sort(all_parents.begin(), all_parents.end());

    for (const auto &[parent, d] : chosen)
      {
        const std::uint64_t place = std::lower_bound(all_parents.begin(),
                                                     all_parents.end(),
                                                     points.ids()[parent]) -
                                    all_parents.begin();
        points.data(PointColumn::mass)[parent] *= 0.5;
        points.data(PointColumn::initial_volume)[parent] *= 0.5;
        points.insert(next_id + place, {}, {}, 0., 0.);
        const std::size_t child = points.size() - 1;
        for (const PointColumnInfo &info : point_column_table)
          if (points.has(info.column))
            for (unsigned int c = 0; c < n_components(info.column, dim); ++c)
              points.data(info.column, c)[child] =
                points.data(info.column, c)[parent];
        for (unsigned int c = 0; c < dim; ++c)
          {
            points.data(PointColumn::position, c)[parent] += d[c];
            points.data(PointColumn::position, c)[child] -= d[c];
            if (!points.has(PointColumn::velocity_gradient))
              continue;
            double difference = 0.;
            for (unsigned int e = 0; e < dim; ++e)
              difference += d[e] * points.data(PointColumn::velocity_gradient,
                                               c * dim + e)[parent];
            points.data(PointColumn::velocity, c)[parent] += difference;
            points.data(PointColumn::velocity, c)[child] -= difference;
          }
      }
    next_id += all_parents.size();
    return chosen.size();
  }

  template <int dim>
  void
  Reseeding<dim>::choose(
    const unsigned int                                   cell,
    const PointCloud<dim>                               &points,
    std::vector<std::pair<std::size_t, Tensor<1, dim>>> &chosen) const
  {
    const double            *volume = points.data(PointColumn::initial_volume);
    std::vector<std::size_t> own;
    std::vector<Point<dim>>  places;
    for (const std::size_t p : points.points_in(cell))
      {
        own.push_back(p);
        places.push_back(points.position(p));
      }
    // the largest first; equal ones in the order of ids
    std::stable_sort(own.begin(), own.end(), [&](const auto a, const auto b) {
      return volume[a] > volume[b];
    });
    const std::size_t wanted = fewest * size_of(cell);
    // halves of smaller ones would be lighter than those that are merged
    const double smallest =
      occupancy.locator.cells.geometry(cell).measure / (most * size_of(cell));
    for (const std::size_t p : own)
      {
        if (places.size() >= wanted || volume[p] < smallest)
          break;
        const double         length = 0.25 * std::pow(volume[p], 1. / dim);
        const Tensor<1, dim> d =
          direction(cell, points.position(p), length, places);
        if (d.norm() < 0.01 * length)
          continue;
        chosen.emplace_back(p, d);
        places[p - points.first_point(cell)] = points.position(p) + d;
        places.push_back(points.position(p) - d);
      }
  }

  template <int dim>
  Tensor<1, dim>
  Reseeding<dim>::direction(const unsigned int             cell,
                            const Point<dim>              &x,
                            const double                   length,
                            const std::vector<Point<dim>> &others) const
  {
    const auto    &locator = occupancy.locator;
    Tensor<1, dim> best;
    double         best_room = -1.;
    // axes and diagonals: digits -1, 0, 1 to the base 3, one of each pair
    const unsigned int n_codes = dim == 2 ? 9 : 27;
    for (unsigned int code = (n_codes + 1) / 2; code < n_codes; ++code)
      {
        Tensor<1, dim> d;
        unsigned int   digits = code;
        for (unsigned int c = 0; c < dim; ++c, digits /= 3)
          d[c] = static_cast<int>(digits % 3) - 1;
        d *= length / d.norm();
        // both places in the cell, off its faces
        double scale = 1.;
        for (unsigned int c = 0; c < dim; ++c)
          if (d[c] != 0.)
            scale =
              std::min(scale,
                       0.99 *
                         std::min(x[c] - locator.cells.geometry(cell).lower[c],
                                  locator.cells.geometry(cell).upper[c] -
                                    x[c]) /
                         std::abs(d[c]));
        d *= std::max(scale, 0.);
        double room = 4. * d.norm_square();
        for (const Point<dim> &other : others)
          if (other != x)
            room = std::min({room,
                             other.distance_square(x + d),
                             other.distance_square(x - d)});
        // a clear difference, so that round-off cannot choose
        if (room > (1. + 1e-9) * best_room)
          {
            best_room = room;
            best      = d;
          }
      }
    return best;
  }

  template class Reseeding<2>;
  template class Reseeding<3>;
} // namespace seiche
