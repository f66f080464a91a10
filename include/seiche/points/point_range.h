// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_point_range_h
#define seiche_points_point_range_h

#include <seiche/points/point_cloud.h>
#include <seiche/utilities/lanes.h>

#include <algorithm>

namespace seiche
{
  /// Material points of one cell at once, as many as Lanes have or what is left
  /// of them: lanes beyond repeat the first point.
  struct PointRange
  {
    std::size_t  first;
    unsigned int size;

    /// Of a column of the cloud.
    Lanes
    load(const double *column) const
    {
      const double *values = column + first;
      if (size == n_lanes_of_register)
        return seiche::load<Lanes>(values);
      return Lanes(
        [&](const unsigned int l) { return values[l < size ? l : 0]; });
    }

    /// The same with zeros beyond: for sums over the points.
    Lanes
    load_weights(const double *column) const
    {
      const double *values = column + first;
      if (size == n_lanes_of_register)
        return seiche::load<Lanes>(values);
      return Lanes(
        [&](const unsigned int l) { return l < size ? values[l] : 0.; });
    }

    void
    store(const Lanes &lanes, double *column) const
    {
      double *values = column + first;
      if (size == n_lanes_of_register)
        lanes.copy_to(values, std::experimental::element_aligned);
      else
        for (unsigned int l = 0; l < size; ++l)
          values[l] = lanes[l];
    }

    /// @p x: columns of the positions.
    template <std::size_t dim, typename Column>
    dealii::Point<static_cast<int>(dim), Lanes>
    position(const std::array<Column, dim> &x) const
    {
      dealii::Point<static_cast<int>(dim), Lanes> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = load(x[d]);
      return result;
    }
  };

  /// action(range) on all points of an own cell.
  template <int dim, typename Action>
  void
  for_each_range(const PointCloud<dim> &points,
                 const unsigned int     cell,
                 const Action          &action)
  {
    const std::size_t end = points.first_point(cell + 1);
    for (std::size_t p = points.first_point(cell); p < end;
         p += n_lanes_of_register)
      action(
        PointRange{p,
                   static_cast<unsigned int>(
                     std::min<std::size_t>(n_lanes_of_register, end - p))});
  }
} // namespace seiche

#endif
