// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_occupied_cells_h
#define seiche_space_occupied_cells_h

#include <seiche/mesh/cell_locator.h>
#include <seiche/points/point_cloud.h>

#include <cstdint>
#include <vector>

namespace seiche
{
  /**
   * @brief The cells that hold fluid, and the halo of cells around them.
   *
   * A cell is occupied if it holds a point or has an inside (add()), active if
   * it is occupied or was at most two cells away from an occupied one when the
   * halo was made.
   */
  template <int dim>
  class OccupiedCells
  {
  public:
    /// @p locator must outlive the object.
    explicit OccupiedCells(const CellLocator<dim> &locator);

    /// No cell is occupied; after each change of the mesh.
    void
    reinit();

    /// Those that hold points. False if one of them is at the edge of the halo,
    /// on any rank: make_halo() is needed. Collective.
    bool
    update(const PointCloud<dim> &points);

    /// Collective.
    void
    make_halo();

    /// Own active cells without points that are occupied as well, until the
    /// next update(). Collective.
    void
    add(const std::vector<unsigned int> &cells);

    /// Own occupied cells, ascending local numbers.
    const std::vector<unsigned int> &
    occupied() const
    {
      return own;
    }

    /// Of all ranks.
    std::uint64_t
    n_global() const
    {
      return n_of_all_ranks;
    }

    /// For own and ghost cells.
    bool
    is_occupied(const unsigned int cell) const
    {
      return occupied_flag[cell];
    }

    /// The same without those of add().
    bool
    holds_points(const unsigned int cell) const
    {
      return points_flag[cell];
    }

    bool
    is_active(const unsigned int cell) const
    {
      return active_flag[cell];
    }

    const CellLocator<dim> &locator;

  private:
    void
    count();
    /// True if @p flags has all own cells around one, and itself.
    bool
    surrounded(const unsigned int cell, const std::vector<char> &flags) const;

    std::vector<unsigned int> own;
    std::uint64_t             n_of_all_ranks = 0;
    std::vector<char>         points_flag, occupied_flag, active_flag;
  };
} // namespace seiche

#endif
