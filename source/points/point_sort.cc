// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_cloud.h>

#include <algorithm>

// The part of PointCloud that keeps the points in the order (cell, id).
namespace seiche
{
  namespace
  {
    /// array[i] <- array[permutation[i]]
    template <typename Array, typename Index>
    void
    permute(Array &array, Array &scratch, const std::vector<Index> &permutation)
    {
      scratch.resize(permutation.size());
      const auto *const source = array.data();
      auto *const       target = scratch.data();
      for (std::size_t i = 0; i < permutation.size(); ++i)
        target[i] = source[permutation[i]];
      array.swap(scratch);
    }
  } // namespace



  template <int dim>
  void
  PointCloud<dim>::sort()
  {
    build_cell_index();

    // counting sort: stable, so that a nearly sorted cloud stays nearly so
    permutation.resize(cell_begin.back());
    for (std::size_t p = 0; p < point_cells.size(); ++p)
      if (point_cells[p] < locator.cells.n_owned())
        permutation[cell_begin[point_cells[p]]++] = p;
    // every entry has become the next one
    for (std::size_t cell = cell_begin.size() - 1; cell > 0; --cell)
      cell_begin[cell] = cell_begin[cell - 1];
    cell_begin[0] = 0;

    order_within_cells();
    apply_permutation();
  }



  template <int dim>
  void
  PointCloud<dim>::build_cell_index()
  {
    cell_begin.assign(locator.cells.n_owned() + 1, 0);
    for (const unsigned int cell : point_cells)
      if (cell < locator.cells.n_owned())
        ++cell_begin[cell + 1];
    for (std::size_t cell = 1; cell < cell_begin.size(); ++cell)
      cell_begin[cell] += cell_begin[cell - 1];
  }



  template <int dim>
  void
  PointCloud<dim>::order_within_cells()
  {
    const auto by_id = [this](const std::uint32_t a, const std::uint32_t b) {
      return point_ids[a] < point_ids[b];
    };
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const auto begin = permutation.begin() + cell_begin[cell];
        const auto end   = permutation.begin() + cell_begin[cell + 1];
        if (!std::is_sorted(begin, end, by_id))
          std::sort(begin, end, by_id);
      }
  }



  template <int dim>
  void
  PointCloud<dim>::apply_permutation()
  {
    for (auto &array : arrays)
      permute(array, scratch_values, permutation);
    permute(point_ids, scratch_ids, permutation);
    permute(point_cells, scratch_cells, permutation);
  }



  template void
  PointCloud<2>::sort();
  template void
  PointCloud<3>::sort();
  template void
  PointCloud<2>::build_cell_index();
  template void
  PointCloud<3>::build_cell_index();
} // namespace seiche
