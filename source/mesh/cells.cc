// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/cells.h>

#include <deal.II/base/mpi.h>

#include <deal.II/grid/grid_tools.h>

#include <optional>

namespace seiche
{
  template <int dim>
  Cells<dim>::Cells(const BackgroundGrid<dim> &background_grid)
    : grid(background_grid)
  {}



  template <int dim>
  void
  Cells<dim>::reinit(CellLattice<dim> &lattice)
  {
    const auto &triangulation = grid.triangulation;
    iterators.clear();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        iterators.push_back(cell);
    n_owned_cells = iterators.size();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_ghost())
        iterators.push_back(cell);
    by_active_index.assign(triangulation.n_active_cells(), invalid);
    for (unsigned int cell = 0; cell < size(); ++cell)
      by_active_index[iterators[cell]->active_cell_index()] = cell;

    lattice.reinit(iterators);
    find_walls(lattice);
    find_face_neighbors(lattice);
    find_vertex_neighbors(lattice);
    move(lattice);
  }



  template <int dim>
  void
  Cells<dim>::move(const CellLattice<dim> &lattice)
  {
    geometries.resize(size());
    for (unsigned int cell = 0; cell < size(); ++cell)
      geometries[cell] = lattice.geometry(cell);
    find_reaches();
  }



  template <int dim>
  void
  Cells<dim>::find_solids(const std::vector<Solid<dim>> &solids)
  {
    if (solids.empty())
      return;
    std::vector<dealii::Point<dim>> centres(size());
    for (unsigned int cell = 0; cell < size(); ++cell)
      centres[cell] = geometries[cell].box().center();
    const auto distances = distances_of_centres.at(solids, centres);
    near_solids.resize(size());
    for (unsigned int cell = 0; cell < size(); ++cell)
      near_solids[cell] = distances[cell] < 1.5 * geometries[cell].edges.norm();
  }



  template <int dim>
  void
  Cells<dim>::find_walls(const CellLattice<dim> &lattice)
  {
    walls.resize(size());
    for (unsigned int cell = 0; cell < size(); ++cell)
      for (const unsigned int face : iterators[cell]->face_indices())
        walls[cell][face] =
          iterators[cell]->at_boundary(face) && !lattice.at_seam(cell, face) ?
            &grid.wall_at(iterators[cell]->face(face)) :
            nullptr;
  }



  template <int dim>
  template <typename Number>
  void
  Cells<dim>::exchange_to_ghosts(std::vector<Number> &cell_values) const
  {
    AssertDimension(cell_values.size(), size());
    if (dealii::Utilities::MPI::n_mpi_processes(
          grid.triangulation.get_communicator()) == 1)
      return;
    dealii::GridTools::exchange_cell_data_to_ghosts<Number>(
      grid.triangulation,
      [&](const Iterator &cell) -> std::optional<Number> {
        return cell_values[index(cell)];
      },
      [&](const Iterator &cell, const Number value) {
        cell_values[index(cell)] = value;
      });
  }



  template class Cells<2>;
  template class Cells<3>;
  template void
  Cells<2>::exchange_to_ghosts(std::vector<double> &) const;
  template void
  Cells<3>::exchange_to_ghosts(std::vector<double> &) const;
  template void
  Cells<2>::exchange_to_ghosts(std::vector<char> &) const;
  template void
  Cells<3>::exchange_to_ghosts(std::vector<char> &) const;
} // namespace seiche
