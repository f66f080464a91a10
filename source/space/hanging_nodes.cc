// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/hanging_nodes.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <optional>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  HangingNodes<dim>::reinit(const DoFHandler<dim>  &dof_handler,
                            const CellLocator<dim> &locator,
                            const NodeMasters<dim> &masters)
  {
    n_nodes = dof_handler.get_fe().n_dofs_per_cell();
    cell_nodes.assign(locator.cells.size() * n_nodes,
                      numbers::invalid_dof_index);
    matrix_of_cell.assign(locator.cells.size(), nullptr);
    matrices.clear();

    std::vector<types::global_dof_index> dofs;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        get_nodes(dof_handler, locator, cell, dofs);
        resolve(cell, dofs, masters);
      }
    exchange(locator);
  }

  template <int dim>
  void
  HangingNodes<dim>::resolve(const unsigned int                          cell,
                             const std::vector<types::global_dof_index> &dofs,
                             const NodeMasters<dim> &masters)
  {
    types::global_dof_index  *nodes = &cell_nodes[cell * n_nodes];
    std::vector<unsigned int> hanging;
    for (unsigned int a = 0; a < n_nodes; ++a)
      if (masters.hangs(dofs[a]))
        hanging.push_back(a);
      else
        nodes[a] = masters.unknown(dofs[a]);
    if (hanging.empty())
      return;

    std::vector<typename NodeMasters<dim>::Weights> weights(n_nodes);
    for (const unsigned int a : hanging)
      weights[a] = masters.masters(dofs[a]);
    const auto masters_of = [&](const unsigned int a) -> const auto &
    {
      return weights[a];
    };
    const auto place_of = [&](const types::global_dof_index node) {
      return std::find(nodes, nodes + n_nodes, node) - nodes;
    };
    // nodes on edges first: with degree 1 each then takes its own master, which
    // lies in the same corner of the parent, and the middle of a face none
    std::stable_sort(hanging.begin(),
                     hanging.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return masters_of(a).size() < masters_of(b).size();
                     });
    const auto is_free = [&](const unsigned int a) {
      return nodes[a] == numbers::invalid_dof_index;
    };
    for (const unsigned int a : hanging)
      for (const auto &[master, weight] : masters_of(a))
        if (place_of(master) == n_nodes)
          {
            const auto slot =
              is_free(a) ?
                std::find(hanging.begin(), hanging.end(), a) :
                std::find_if(hanging.begin(), hanging.end(), is_free);
            AssertThrow(slot != hanging.end(),
                        ExcMessage("More masters than hanging nodes."));
            nodes[*slot] = master;
          }
    for (const unsigned int a : hanging)
      if (is_free(a))
        nodes[a] = masters_of(a).front().first; // its column is zero

    std::vector<double> C(n_nodes * n_nodes, 0.);
    for (unsigned int a = 0; a < n_nodes; ++a)
      if (!masters.hangs(dofs[a]))
        C[a * n_nodes + a] = 1.;
      else
        for (const auto &[master, weight] : masters_of(a))
          C[a * n_nodes + place_of(master)] = weight;
    matrix_of_cell[cell] = matrices.store(C, n_nodes);
  }

  template <int dim>
  void
  HangingNodes<dim>::exchange(const CellLocator<dim> &locator)
  {
    const auto &triangulation = locator.grid.triangulation;
    if (Utilities::MPI::n_mpi_processes(triangulation.get_communicator()) == 1)
      return;
    using Iterator =
      typename parallel::distributed::Triangulation<dim>::active_cell_iterator;
    // nodes, and the matrix if there is one
    using Packet =
      std::pair<std::vector<types::global_dof_index>, std::vector<double>>;
    GridTools::exchange_cell_data_to_ghosts<Packet>(
      triangulation,
      [&](const Iterator &iterator) -> std::optional<Packet> {
        const unsigned int cell = locator.cells.index(iterator);
        return Packet({nodes(cell), nodes(cell) + n_nodes},
                      matrix(cell) != nullptr ? matrix(cell)->dense() :
                                                std::vector<double>());
      },
      [&](const Iterator &iterator, const Packet &packet) {
        const unsigned int cell = locator.cells.index(iterator);
        std::copy(packet.first.begin(),
                  packet.first.end(),
                  &cell_nodes[cell * n_nodes]);
        if (!packet.second.empty())
          matrix_of_cell[cell] = matrices.store(packet.second, n_nodes);
      });
  }

  template class HangingNodes<2>;
  template class HangingNodes<3>;
} // namespace seiche
