// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/component_partitioner.h>
#include <seiche/space/occupancy.h>
#include <seiche/utilities/exceptions.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  Occupancy<dim>::Occupancy(const CellLocator<dim> &cell_locator,
                            const unsigned int      degree)
    : locator(cell_locator)
    , fe(degree)
    , mesh_nodes(locator, fe)
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
    points_flag.assign(locator.n_cells(), 0);
    occupied_flag.assign(locator.n_cells(), 0);
    active_flag.assign(locator.n_cells(), 0);
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
    for (unsigned int cell = 0; cell < locator.n_owned(); ++cell)
      smallest = std::min(smallest, locator.geometry(cell).shortest_edge());
    smallest =
      Utilities::MPI::min(smallest,
                          locator.grid.triangulation.get_communicator());
  }

  template <int dim>
  void
  Occupancy<dim>::update(const PointCloud<dim> &points)
  {
    const MPI_Comm communicator = locator.grid.triangulation.get_communicator();
    for (unsigned int cell = 0; cell < locator.n_owned(); ++cell)
      occupied_flag[cell] = points.n_points_in(cell) > 0;
    locator.exchange_to_ghosts(occupied_flag);
    points_flag = occupied_flag;
    occupied.clear();
    bool inside = is_numbered;
    for (unsigned int cell = 0; cell < locator.n_owned(); ++cell)
      if (occupied_flag[cell])
        {
          occupied.push_back(cell);
          const auto neighbors = locator.vertex_neighbors(cell);
          inside =
            inside && active_flag[cell] &&
            std::all_of(neighbors.begin(),
                        neighbors.end(),
                        [&](const unsigned int c) { return active_flag[c]; });
        }
    global_occupied =
      Utilities::MPI::sum(static_cast<std::uint64_t>(occupied.size()),
                          communicator);
    if (Utilities::MPI::min(inside ? 1 : 0, communicator) == 0)
      number();
    reset_matrices();
    constraints.reinit(full_of_compact, node_partitioner);
  }

  template <int dim>
  void
  Occupancy<dim>::occupy(const std::vector<unsigned int> &cells)
  {
    for (const unsigned int cell : cells)
      occupied_flag[cell] = true;
    locator.exchange_to_ghosts(occupied_flag);
    occupied.insert(occupied.end(), cells.begin(), cells.end());
    std::sort(occupied.begin(), occupied.end());
    global_occupied =
      Utilities::MPI::sum(static_cast<std::uint64_t>(occupied.size()),
                          locator.grid.triangulation.get_communicator());
  }

  template <int dim>
  void
  Occupancy<dim>::reset_matrices()
  {
    cell_matrices.resize(locator.n_cells());
    for (unsigned int cell = 0; cell < locator.n_cells(); ++cell)
      cell_matrices[cell] = mesh_nodes.hanging.matrix(cell);
    linear_flag.assign(locator.n_cells(), fe.degree == 1);
  }

  template <int dim>
  void
  Occupancy<dim>::set_linear(const std::vector<char> &flags)
  {
    if (fe.degree == 1)
      return;
    std::copy(flags.begin(), flags.end(), linear_flag.begin());
    locator.exchange_to_ghosts(linear_flag);
    const unsigned int n_nodes = nodes_per_cell();
    Vector             is_mean(node_partitioner);
    for (const unsigned int cell : occupied)
      if (linear_flag[cell])
        for (unsigned int a = 0; a < n_nodes; ++a)
          if (mesh_nodes.linear_cells.is_middle(cell, a))
            is_mean.local_element(cell_nodes(cell)[a]) = 1.;
    is_mean.compress(VectorOperation::add);
    is_mean.update_ghost_values();
    for (unsigned int cell = 0; cell < locator.n_cells(); ++cell)
      if (active_flag[cell])
        {
          unsigned int means = 0;
          for (unsigned int a = 0; a < n_nodes; ++a)
            if (is_mean.local_element(cell_nodes(cell)[a]) > 0.)
              means |= 1u << a;
          cell_matrices[cell] = mesh_nodes.linear_cells.matrix(cell, means);
        }
  }

  template <int dim>
  void
  Occupancy<dim>::activate_cells()
  {
    // boxes of points reach into the first layer; the second saves numberings
    active_flag = occupied_flag;
    for (unsigned int layer = 0; layer < 2; ++layer)
      {
        const std::vector<char> before = active_flag;
        for (unsigned int cell = 0; cell < locator.n_owned(); ++cell)
          {
            const auto neighbors = locator.vertex_neighbors(cell);
            active_flag[cell] =
              before[cell] ||
              std::any_of(neighbors.begin(),
                          neighbors.end(),
                          [&](const unsigned int c) { return before[c]; });
          }
        locator.exchange_to_ghosts(active_flag);
      }
  }

  template <int dim>
  void
  Occupancy<dim>::number()
  {
    activate_cells();
    const std::vector<char> used = find_used_nodes();
    number_nodes(used);

    const unsigned int        n_nodes = nodes_per_cell();
    std::vector<unsigned int> compact_of_full(used.size(), invalid);
    for (unsigned int i = 0; i < full_of_compact.size(); ++i)
      compact_of_full[full_of_compact[i]] = i;
    compact_cell_nodes.assign(locator.n_cells() * n_nodes, invalid);
    for (unsigned int cell = 0; cell < locator.n_cells(); ++cell)
      if (active_flag[cell])
        for (unsigned int a = 0; a < n_nodes; ++a)
          compact_cell_nodes[cell * n_nodes + a] =
            compact_of_full[mesh_nodes.of_cell(cell)[a]];
    ++numbering_generation;
    is_numbered = true;
  }

  template <int dim>
  void
  Occupancy<dim>::number_nodes(const std::vector<char> &used)
  {
    const unsigned int n_own_full =
      mesh_nodes.partitioner()->locally_owned_size();
    n_own = std::count(used.begin(), used.begin() + n_own_full, 1);
    const MPI_Comm communicator = locator.grid.triangulation.get_communicator();
    const auto     counts =
      Utilities::MPI::all_gather(communicator, std::uint64_t(n_own));
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
    Vector compact(mesh_nodes.partitioner());
    full_of_compact.clear();
    for (unsigned int i = 0; i < n_own_full; ++i)
      if (used[i])
        {
          compact.local_element(i) =
            static_cast<double>(begin + full_of_compact.size());
          full_of_compact.push_back(i);
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
        full_of_compact.push_back(full);
        ghost_nodes.push_back(global);
      }
    IndexSet own_set(n_global), ghost_set(n_global);
    own_set.add_range(begin, begin + n_own);
    ghost_set.add_indices(ghost_nodes.begin(), ghost_nodes.end());
    node_partitioner =
      std::make_shared<const Utilities::MPI::Partitioner>(own_set,
                                                          ghost_set,
                                                          communicator);
    vector_layout = component_partitioner(*node_partitioner, dim);
  }

  template <int dim>
  std::vector<char>
  Occupancy<dim>::find_used_nodes() const
  {
    const unsigned int n_nodes = nodes_per_cell();
    std::vector<char>  used(mesh_nodes.size(), 0);
    for (unsigned int cell = 0; cell < locator.n_cells(); ++cell)
      if (active_flag[cell])
        for (unsigned int a = 0; a < n_nodes; ++a)
          used[mesh_nodes.of_cell(cell)[a]] = 1;
    // the owner of a master may not see the cell whose hanging node needs it
    Vector mark(mesh_nodes.partitioner());
    for (unsigned int i = 0; i < used.size(); ++i)
      mark.local_element(i) = used[i];
    mark.compress(VectorOperation::add);
    for (unsigned int i = 0; i < mesh_nodes.partitioner()->locally_owned_size();
         ++i)
      used[i] = mark.local_element(i) > 0.;
    return used;
  }

  template class Occupancy<2>;
  template class Occupancy<3>;
} // namespace seiche
