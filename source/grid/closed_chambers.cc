// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/closed_chambers.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  ClosedChambers<dim>::ClosedChambers(const Occupancy<dim> &grid_occupancy)
    : chambers(grid_occupancy.locator.grid)
    , occupancy(grid_occupancy)
    , closed(chambers.size(), 0)
  {}

  template <int dim>
  void
  ClosedChambers<dim>::update(
    const std::function<bool(const unsigned int)> &fluid_fills)
  {
    const auto               &locator = occupancy.locator;
    std::vector<unsigned int> has_room(chambers.size());
    for (unsigned int chamber = 0; chamber < chambers.size(); ++chamber)
      has_room[chamber] = chambers.is_open(chamber);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (!fluid_fills(cell))
        has_room[chambers.index(locator.cells.iterator(cell))] = 1;
    const MPI_Comm communicator =
      occupancy.nodes.partitioner()->get_mpi_communicator();
    Utilities::MPI::max(has_room, communicator, has_room);
    std::transform(has_room.begin(),
                   has_room.end(),
                   closed.begin(),
                   [](const unsigned int room) { return room == 0; });
    n_closed = std::count(closed.begin(), closed.end(), 1);
    of_node.clear();
    if (!any())
      return;

    of_node.assign(occupancy.nodes.n_own(), none);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (holds_cell(cell))
        for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
          if (const unsigned int node = occupancy.nodes.of_cell(cell)[a];
              node < of_node.size())
            of_node[node] = chambers.index(locator.cells.iterator(cell));
  }

  template <int dim>
  template <typename Weight, typename Shape>
  void
  ClosedChambers<dim>::subtract(Vector       &values,
                                const Weight &weight,
                                const Shape  &shape) const
  {
    std::vector<double> sums(2 * chambers.size()); // of values, of shapes
    for (unsigned int node = 0; node < of_node.size(); ++node)
      if (const unsigned int chamber = of_node[node]; chamber != none)
        {
          sums[2 * chamber] += weight(node) * values.local_element(node);
          sums[2 * chamber + 1] += weight(node) * shape(node);
        }
    Utilities::MPI::sum(sums, values.get_mpi_communicator(), sums);
    for (unsigned int node = 0; node < of_node.size(); ++node)
      if (const unsigned int chamber = of_node[node]; chamber != none)
        values.local_element(node) -=
          sums[2 * chamber] / sums[2 * chamber + 1] * shape(node);
  }

  template <int dim>
  void
  ClosedChambers<dim>::balance_rows(Vector &rows, const Vector &mass) const
  {
    subtract(
      rows,
      [](const unsigned int) { return 1.; },
      [&mass](const unsigned int node) { return mass.local_element(node); });
  }

  template <int dim>
  void
  ClosedChambers<dim>::level_pressure(Vector &pressure) const
  {
    subtract(
      pressure,
      [this](const unsigned int node) { return occupancy.nodes.volume(node); },
      [](const unsigned int) { return 1.; });
  }

  template <int dim>
  void
  ClosedChambers<dim>::remove_constants(Vector &values) const
  {
    const auto one = [](const unsigned int) { return 1.; };
    subtract(values, one, one);
  }

  template <int dim>
  std::vector<types::global_dof_index>
  ClosedChambers<dim>::first_nodes() const
  {
    const auto                          &nodes = *occupancy.nodes.partitioner();
    std::vector<types::global_dof_index> first(chambers.size(), nodes.size());
    for (unsigned int node = of_node.size(); node-- > 0;)
      if (of_node[node] != none && occupancy.nodes.volume(node) > 0.)
        first[of_node[node]] = nodes.local_to_global(node);
    Utilities::MPI::min(first, nodes.get_mpi_communicator(), first);
    first.erase(std::remove(first.begin(), first.end(), nodes.size()),
                first.end());
    return first;
  }

  template class ClosedChambers<2>;
  template class ClosedChambers<3>;
} // namespace seiche
