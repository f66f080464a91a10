// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/occupied_cells.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  OccupiedCells<dim>::OccupiedCells(const CellLocator<dim> &cell_locator)
    : locator(cell_locator)
  {}

  template <int dim>
  void
  OccupiedCells<dim>::reinit()
  {
    points_flag.assign(locator.cells.size(), 0);
    occupied_flag.assign(locator.cells.size(), 0);
    active_flag.assign(locator.cells.size(), 0);
  }

  template <int dim>
  bool
  OccupiedCells<dim>::surrounded(const unsigned int       cell,
                                 const std::vector<char> &flags) const
  {
    const auto neighbors = locator.cells.vertex_neighbors(cell);
    return flags[cell] &&
           std::all_of(neighbors.begin(),
                       neighbors.end(),
                       [&](const unsigned int c) { return flags[c]; });
  }

  template <int dim>
  bool
  OccupiedCells<dim>::update(const PointCloud<dim> &points)
  {
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      occupied_flag[cell] = points.n_points_in(cell) > 0;
    locator.cells.exchange_to_ghosts(occupied_flag);
    points_flag = occupied_flag;
    own.clear();
    bool inside = true;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (occupied_flag[cell])
        {
          own.push_back(cell);
          inside = inside && surrounded(cell, active_flag);
        }
    count();
    return Utilities::MPI::min(inside ? 1 : 0,
                               locator.grid.triangulation.get_communicator()) >
           0;
  }

  template <int dim>
  void
  OccupiedCells<dim>::make_halo()
  {
    // boxes of points reach into the first layer; the second saves numberings
    active_flag = occupied_flag;
    for (unsigned int layer = 0; layer < 2; ++layer)
      {
        const std::vector<char> before = active_flag;
        for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
          {
            const auto neighbors = locator.cells.vertex_neighbors(cell);
            active_flag[cell] =
              before[cell] ||
              std::any_of(neighbors.begin(),
                          neighbors.end(),
                          [&](const unsigned int c) { return before[c]; });
          }
        locator.cells.exchange_to_ghosts(active_flag);
      }
  }

  template <int dim>
  void
  OccupiedCells<dim>::add(const std::vector<unsigned int> &cells)
  {
    for (const unsigned int cell : cells)
      occupied_flag[cell] = true;
    locator.cells.exchange_to_ghosts(occupied_flag);
    own.insert(own.end(), cells.begin(), cells.end());
    std::sort(own.begin(), own.end());
    count();
  }

  template <int dim>
  void
  OccupiedCells<dim>::count()
  {
    n_of_all_ranks =
      Utilities::MPI::sum(static_cast<std::uint64_t>(own.size()),
                          locator.grid.triangulation.get_communicator());
  }

  template class OccupiedCells<2>;
  template class OccupiedCells<3>;
} // namespace seiche
