// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/occupancy.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Occupancy<dim>::Occupancy(const CellLocator<dim> &cell_locator,
                            const unsigned int      degree)
    : locator(cell_locator)
    , fe(degree)
    , mesh_nodes(locator, fe)
    , cells(locator)
    , nodes(mesh_nodes, cells)
    , constraints(mesh_nodes)
  {
    reinit();
  }

  template <int dim>
  void
  Occupancy<dim>::reinit()
  {
    mesh_nodes.reinit();
    reset_matrices();
    find_smallest_extent();
    cells.reinit();
    is_numbered = false;
  }

  template <int dim>
  void
  Occupancy<dim>::update_places()
  {
    mesh_nodes.update_places();
    find_smallest_extent();
  }

  template <int dim>
  void
  Occupancy<dim>::find_smallest_extent()
  {
    smallest = std::numeric_limits<double>::max();
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      smallest =
        std::min(smallest, locator.cells.geometry(cell).shortest_edge());
    smallest =
      Utilities::MPI::min(smallest,
                          locator.grid.triangulation.get_communicator());
  }

  template <int dim>
  void
  Occupancy<dim>::update(const PointCloud<dim> &points)
  {
    if (!cells.update(points) || !is_numbered)
      {
        cells.make_halo();
        nodes.reinit();
        is_numbered = true;
      }
    reset_matrices();
    constraints.reinit(nodes.in_mesh(), nodes.partitioner());
    zero_components.clear();
  }

  template <int dim>
  void
  Occupancy<dim>::reset_matrices()
  {
    cell_matrices.resize(locator.cells.size());
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      cell_matrices[cell] = mesh_nodes.hanging.matrix(cell);
    linear_flag.assign(locator.cells.size(), fe.degree == 1);
  }

  template <int dim>
  void
  Occupancy<dim>::set_linear(const std::vector<char> &flags)
  {
    if (fe.degree == 1)
      return;
    std::copy(flags.begin(), flags.end(), linear_flag.begin());
    locator.cells.exchange_to_ghosts(linear_flag);
    const unsigned int n_nodes = nodes_per_cell();
    Vector             is_mean(nodes.partitioner());
    for (const unsigned int cell : cells.occupied())
      if (linear_flag[cell])
        for (unsigned int a = 0; a < n_nodes; ++a)
          if (mesh_nodes.linear_cells.is_middle(cell, a))
            is_mean.local_element(nodes.of_cell(cell)[a]) = 1.;
    is_mean.compress(VectorOperation::add);
    is_mean.update_ghost_values();
    for (unsigned int cell = 0; cell < locator.cells.size(); ++cell)
      if (cells.is_active(cell))
        {
          unsigned int means = 0;
          for (unsigned int a = 0; a < n_nodes; ++a)
            if (is_mean.local_element(nodes.of_cell(cell)[a]) > 0.)
              means |= 1u << a;
          cell_matrices[cell] = mesh_nodes.linear_cells.matrix(cell, means);
        }
  }

  template class Occupancy<2>;
  template class Occupancy<3>;
} // namespace seiche
