// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_reseeding_h
#define seiche_grid_reseeding_h

#include <seiche/grid/fill.h>

#include <cstdint>
#include <optional>

namespace seiche
{
  /**
   * @brief Splits points in inner cells that hold few, merges them in inner
   * cells that hold many.
   *
   * Inner cells touch no unoccupied cell. Mass and initial volume are kept
   * exactly, momentum to round-off; kinetic energy and angular momentum change
   * (PointControl reports by how much).
   *
   * A split (doc/theory.md (5.5)) replaces a point at x by two at x + d and x -
   * d with half its mass and initial volume, its J, pressure and gradient C,
   * and velocities v +- C d; |d| is a quarter of the edge of its volume, and d
   * the direction (axes and diagonals of the cell) that leaves most room. A
   * merger puts the lightest point of a cell and its nearest neighbour into
   * their mass centre; momentum, volume and J V0 add up.
   *
   * Decisions depend on the points of a cell alone, and new ids on the sorted
   * list of the points that are split anywhere, so that they do not depend on
   * the number of ranks.
   */
  template <int dim>
  class Reseeding
  {
  public:
    /// @p fewest and @p most points in a cell of the finest level;
    /// @p most is at least twice @p fewest.
    Reseeding(const Fill<dim>   &grid_fill,
              const unsigned int fewest,
              const unsigned int most);

    /// Number of points removed, own cells. The order of the others stays.
    /// Local.
    std::uint64_t
    merge(PointCloud<dim> &points) const;

    /// Number of points added, own cells: ids from @p next_id on, which grows
    /// by the number on all ranks. PointCloud::locate() must follow.
    /// Collective.
    std::uint64_t
    split(PointCloud<dim> &points, std::uint64_t &next_id) const;

  private:
    /// Number of cells of the finest level in a cell.
    std::size_t
    size_of(const unsigned int cell) const;

    /// Merge the lightest of the cell's @p alive points with its nearest
    /// neighbour; the number that goes. None if no other may be merged with
    /// it, which is not looked at again then.
    std::optional<std::size_t>
    merge_pair(PointCloud<dim> &points, std::vector<std::size_t> &alive) const;

    /// Points of the cell to be split and their d, appended.
    void
    choose(const unsigned int                                           cell,
           const PointCloud<dim>                                       &points,
           std::vector<std::pair<std::size_t, dealii::Tensor<1, dim>>> &chosen)
      const;

    /// The best d for a point at @p x among @p others; zero if there is no
    /// room.
    dealii::Tensor<1, dim>
    direction(const unsigned int                     cell,
              const dealii::Point<dim>              &x,
              const double                           length,
              const std::vector<dealii::Point<dim>> &others) const;

    const Fill<dim>      &fill;
    const Occupancy<dim> &occupancy;
    const unsigned int    fewest, most;
  };
} // namespace seiche

#endif
