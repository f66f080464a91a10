// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cell_lattice.h>
#include <seiche/mesh/morton_key.h>

#include <algorithm>

namespace seiche
{
  template <int dim>
  CellLattice<dim>::CellLattice(const GridLines<dim> &grid_lines,
                                const Periods<dim>   &grid_periods)
    : lines(grid_lines)
    , periods(grid_periods)
  {}



  template <int dim>
  void
  CellLattice<dim>::reinit(const std::vector<CellIterator> &cells)
  {
    lower.resize(cells.size());
    upper.resize(cells.size());
    by_key.resize(cells.size());
    const unsigned int finest = lines.grid.finest_level();
    for (unsigned int cell = 0; cell < cells.size(); ++cell)
      {
        const unsigned int n      = 1u << (finest - cells[cell]->level());
        const auto         centre = cells[cell]->center();
        for (unsigned int d = 0; d < dim; ++d)
          {
            // a coarse cell's centre lies in its second half
            lower[cell][d] = lines.index_at_start(d, centre[d]) / n * n;
            upper[cell][d] = lower[cell][d] + n;
          }
        by_key[cell] = {morton_key<dim>(lower[cell]), cell};
      }
    std::sort(by_key.begin(), by_key.end());
  }



  template <int dim>
  bool
  CellLattice<dim>::covers(const unsigned int cell, const Index &index) const
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (index[d] < lower[cell][d] || index[d] >= upper[cell][d])
        return false;
    return true;
  }



  template <int dim>
  unsigned int
  CellLattice<dim>::find(const Index &index) const
  {
    const std::uint64_t key = morton_key<dim>(index);
    auto                it  = std::upper_bound(by_key.begin(),
                               by_key.end(),
                               key,
                               [](const std::uint64_t k, const auto &entry) {
                                 return k < entry.first;
                               });
    if (it == by_key.begin())
      return dealii::numbers::invalid_unsigned_int;
    --it;
    return covers(it->second, index) ? it->second :
                                       dealii::numbers::invalid_unsigned_int;
  }



  template <int dim>
  typename CellLattice<dim>::Index
  CellLattice<dim>::place(const unsigned int cell, const Index &halves) const
  {
    Index result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        result[d] = 2 * lower[cell][d] + halves[d] * size(cell);
        if (periods.in(d) && result[d] == 2 * lines.n_cells(d))
          result[d] = 0;
      }
    return result;
  }



  template <int dim>
  std::uint64_t
  CellLattice<dim>::index(const unsigned int cell, const Index &offset) const
  {
    std::uint64_t result = 0;
    for (unsigned int d = dim; d-- > 0;)
      result = result * lines.n_cells(d) + lower[cell][d] + offset[d];
    return result;
  }



  template <int dim>
  double
  CellLattice<dim>::n_lattice_cells() const
  {
    double result = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      result *= lines.n_cells(d);
    return result;
  }



  template <int dim>
  dealii::BoundingBox<dim>
  CellLattice<dim>::box(const unsigned int cell, const Index &offset) const
  {
    Index low, high;
    for (unsigned int d = 0; d < dim; ++d)
      {
        low[d]  = lower[cell][d] + offset[d];
        high[d] = low[d] + 1;
      }
    return lines.box(low, high).box();
  }



  template <int dim>
  bool
  CellLattice<dim>::at_seam(const unsigned int cell) const
  {
    for (unsigned int face = 0; face < 2 * dim; ++face)
      if (at_seam(cell, face))
        return true;
    return false;
  }



  template <int dim>
  unsigned int
  CellLattice<dim>::across_seam(const unsigned int cell,
                                const BoxFace      face) const
  {
    const unsigned int d      = face.direction();
    Index              beyond = lower[cell];
    beyond[d]                 = face.is_upper() ? 0 : lines.n_cells(d) - 1;
    return find(beyond);
  }



  template class CellLattice<2>;
  template class CellLattice<3>;
} // namespace seiche
