// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/component_partitioner.h>
#include <seiche/space/node_numbering.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  NodeNumbering<dim>::NodeNumbering(const MeshNodes<dim>     &mesh_nodes,
                                    const OccupiedCells<dim> &occupied_cells)
    : mesh(mesh_nodes)
    , cells(occupied_cells)
  {}

  template <int dim>
  void
  NodeNumbering<dim>::reinit()
  {
    const std::vector<char> used = find_used_nodes();
    number(used);

    const unsigned int        n_cells = cells.locator.cells.size();
    const unsigned int        n_nodes = mesh.fe.n_dofs_per_cell();
    std::vector<unsigned int> number_of(used.size(),
                                        numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < mesh_node.size(); ++i)
      number_of[mesh_node[i]] = i;
    cell_nodes.assign(n_cells * n_nodes, numbers::invalid_unsigned_int);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      if (cells.is_active(cell))
        for (unsigned int a = 0; a < n_nodes; ++a)
          cell_nodes[cell * n_nodes + a] = number_of[mesh.of_cell(cell)[a]];
    ++n_numberings;
  }

  template <int dim>
  void
  NodeNumbering<dim>::number(const std::vector<char> &used)
  {
    const unsigned int n_own_full = mesh.partitioner()->locally_owned_size();
    n_own_nodes = std::count(used.begin(), used.begin() + n_own_full, 1);
    const MPI_Comm communicator =
      cells.locator.grid.triangulation.get_communicator();
    const auto counts =
      Utilities::MPI::all_gather(communicator, std::uint64_t(n_own_nodes));
    const unsigned int  rank = Utilities::MPI::this_mpi_process(communicator);
    const std::uint64_t begin =
      std::accumulate(counts.begin(), counts.begin() + rank, std::uint64_t(0));
    const std::uint64_t n_global =
      std::accumulate(counts.begin() + rank, counts.end(), begin);
    if (n_global * dim > std::uint64_t(std::numeric_limits<int>::max()))
      throw NumericalError(fmt::format(
        "{} nodes make more than 2^31 - 1 rows in the velocity block; the "
        "matrices of this deal.II have 32-bit indices. Choose larger cells or "
        "smaller levels of refinement.",
        n_global));

    // own numbers to the ranks that see these nodes as ghosts; doubles hold
    // integers up to 2^53
    LinearAlgebra::distributed::Vector<double> compact(mesh.partitioner());
    mesh_node.clear();
    for (unsigned int i = 0; i < n_own_full; ++i)
      if (used[i])
        {
          compact.local_element(i) =
            static_cast<double>(begin + mesh_node.size());
          mesh_node.push_back(i);
        }
    compact.update_ghost_values();
    std::vector<std::pair<types::global_dof_index, unsigned int>> ghosts;
    for (unsigned int i = n_own_full; i < used.size(); ++i)
      if (used[i])
        ghosts.emplace_back(
          static_cast<types::global_dof_index>(compact.local_element(i)), i);
    std::sort(ghosts.begin(), ghosts.end());

    std::vector<types::global_dof_index> ghost_nodes;
    for (const auto &[global, full] : ghosts)
      {
        mesh_node.push_back(full);
        ghost_nodes.push_back(global);
      }
    IndexSet own_set(n_global), ghost_set(n_global);
    own_set.add_range(begin, begin + n_own_nodes);
    ghost_set.add_indices(ghost_nodes.begin(), ghost_nodes.end());
    layout        = std::make_shared<const Utilities::MPI::Partitioner>(own_set,
                                                                 ghost_set,
                                                                 communicator);
    vector_layout = component_partitioner(*layout, dim);
  }

  template <int dim>
  std::vector<char>
  NodeNumbering<dim>::find_used_nodes() const
  {
    const unsigned int n_nodes = mesh.fe.n_dofs_per_cell();
    std::vector<char>  used(mesh.size(), 0);
    for (unsigned int cell = 0; cell < cells.locator.cells.size(); ++cell)
      if (cells.is_active(cell))
        for (unsigned int a = 0; a < n_nodes; ++a)
          used[mesh.of_cell(cell)[a]] = 1;
    // the owner of a master may not see the cell whose hanging node needs it
    LinearAlgebra::distributed::Vector<double> mark(mesh.partitioner());
    for (unsigned int i = 0; i < used.size(); ++i)
      mark.local_element(i) = used[i];
    mark.compress(VectorOperation::add);
    for (unsigned int i = 0; i < mesh.partitioner()->locally_owned_size(); ++i)
      used[i] = mark.local_element(i) > 0.;
    return used;
  }

  template class NodeNumbering<2>;
  template class NodeNumbering<3>;
} // namespace seiche
