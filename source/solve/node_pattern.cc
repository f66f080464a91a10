// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/node_pattern.h>

#include <deal.II/base/mpi.templates.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr int exchange_tag = 4711;
  }

  template <int dim>
  NodePattern<dim>::NodePattern(const Occupancy<dim> &grid_occupancy)
    : occupancy(grid_occupancy)
  {}

  template <int dim>
  bool
  NodePattern<dim>::reinit(const Fill<dim> &fill)
  {
    const bool keep = numbering_generation == occupancy.generation() &&
                      covers(fill.ghost_faces());
    if (Utilities::MPI::min(
          keep ? 1 : 0,
          occupancy.scalar_partitioner()->get_mpi_communicator()) == 1)
      return false;
    numbering_generation = occupancy.generation();
    collect_couplings(fill);
    exchange_couplings();
    build_tables();
    return true;
  }

  template <int dim>
  bool
  NodePattern<dim>::covers(const std::vector<GhostFace> &faces) const
  {
    return std::all_of(faces.begin(), faces.end(), [&](const GhostFace &face) {
      return covered_faces[face_index(face.lower, face.upper, face.direction)];
    });
  }

  template <int dim>
  std::size_t
  NodePattern<dim>::face_index(const unsigned int lower,
                               const unsigned int upper,
                               const unsigned int direction) const
  {
    const auto &locator = occupancy.locator;
    return locator.level(lower) >= locator.level(upper) ?
             lower * 2 * dim + 2 * direction + 1 :
             upper * 2 * dim + 2 * direction;
  }

  template <int dim>
  void
  NodePattern<dim>::collect_couplings(const Fill<dim> &fill)
  {
    // Groups of mutually coupled nodes: cells, and pairs of cells across the
    // faces that may become ghost faces before the next numbering.
    std::vector<unsigned int> group_begin = {0}, group_nodes;
    const auto                add_nodes   = [&](const unsigned int cell) {
      const unsigned int *nodes = occupancy.cell_nodes(cell);
      group_nodes.insert(group_nodes.end(), nodes, nodes + n_nodes);
    };
    for (const unsigned int cell : occupancy.active_cells())
      {
        add_nodes(cell);
        group_begin.push_back(group_nodes.size());
      }
    covered_faces.assign(occupancy.locator.n_cells() * 2 * dim, 0);
    const auto near_surface = [&](const unsigned int cell) {
      return !occupancy.is_occupied(cell) || fill.is_cut(cell);
    };
    occupancy.for_each_assembled_face(
      occupancy.active_cells(),
      [&](const unsigned int cell) { return occupancy.is_active(cell); },
      [&](const unsigned int lower,
          const unsigned int upper,
          const unsigned int direction) {
        if (!near_surface(lower) && !near_surface(upper))
          return;
        covered_faces[face_index(lower, upper, direction)] = 1;
        add_nodes(lower);
        add_nodes(upper);
        group_begin.push_back(group_nodes.size());
      });

    // groups at each node, then the union of their nodes
    const unsigned int        n_rows = occupancy.n_local_nodes();
    std::vector<unsigned int> at_begin(n_rows + 1, 0), at;
    for (const unsigned int node : group_nodes)
      ++at_begin[node + 1];
    std::partial_sum(at_begin.begin(), at_begin.end(), at_begin.begin());
    at.resize(group_nodes.size());
    std::vector<unsigned int> next(at_begin.begin(), at_begin.end() - 1);
    for (unsigned int g = 0; g + 1 < group_begin.size(); ++g)
      for (unsigned int i = group_begin[g]; i < group_begin[g + 1]; ++i)
        at[next[group_nodes[i]]++] = g;

    begin_of_row.assign(1, 0);
    column.clear();
    std::vector<unsigned int> last_seen(n_rows, Occupancy<dim>::invalid);
    for (unsigned int row = 0; row < n_rows; ++row)
      {
        for (unsigned int i = at_begin[row]; i < at_begin[row + 1]; ++i)
          for (unsigned int j = group_begin[at[i]]; j < group_begin[at[i] + 1];
               ++j)
            if (last_seen[group_nodes[j]] != row)
              {
                last_seen[group_nodes[j]] = row;
                column.push_back(group_nodes[j]);
              }
        std::sort(column.begin() + begin_of_row.back(), column.end());
        begin_of_row.push_back(column.size());
      }
  }

  template <int dim>
  void
  NodePattern<dim>::exchange_couplings()
  {
    using Index                     = types::global_dof_index;
    const auto        &nodes        = *occupancy.scalar_partitioner();
    const auto         communicator = nodes.get_mpi_communicator();
    const unsigned int n_own        = occupancy.n_own_nodes();
    sent.clear();
    received.clear();
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      {
        columns = occupancy.scalar_partitioner();
        return;
      }

    // ghost rows to their owners: global row, number of columns, columns
    std::map<unsigned int, std::vector<Index>> outgoing;
    unsigned int                               row = n_own;
    for (const auto &[rank, n_rows] : nodes.ghost_targets())
      {
        std::vector<Index> &message = outgoing[rank];
        sent.push_back(
          {rank, begin_of_row[row], begin_of_row[row + n_rows], {}});
        for (const unsigned int end = row + n_rows; row < end; ++row)
          {
            message.push_back(nodes.local_to_global(row));
            message.push_back(begin_of_row[row + 1] - begin_of_row[row]);
            for (unsigned int k = begin_of_row[row]; k < begin_of_row[row + 1];
                 ++k)
              message.push_back(nodes.local_to_global(column[k]));
          }
      }
    const auto incoming = Utilities::MPI::some_to_some(communicator, outgoing);

    // what is not own gets a number after the own ones
    std::vector<Index> ghosts;
    const auto         note = [&](const Index global) {
      if (!nodes.in_local_range(global))
        ghosts.push_back(global);
    };
    for (unsigned int i = n_own; i < occupancy.n_local_nodes(); ++i)
      note(nodes.local_to_global(i));
    const auto for_each_row = [](const std::vector<Index> &message,
                                 const auto               &f) {
      for (std::size_t i = 0; i < message.size(); i += 2 + message[i + 1])
        f(message[i], message.data() + i + 2, message[i + 1]);
    };
    for (const auto &[rank, message] : incoming)
      for_each_row(message,
                   [&](const Index, const Index *globals, const Index n) {
                     std::for_each(globals, globals + n, note);
                   });
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    IndexSet ghost_set(nodes.size());
    ghost_set.add_indices(ghosts.begin(), ghosts.end());
    columns = std::make_shared<const Utilities::MPI::Partitioner>(
      nodes.locally_owned_range(), ghost_set, communicator);

    // all rows in the new numbers, own rows with what was received
    std::vector<std::vector<unsigned int>> more(n_own);
    for (const auto &[rank, message] : incoming)
      for_each_row(
        message, [&](const Index global, const Index *globals, const Index n) {
          auto &list = more[nodes.global_to_local(global)];
          for (Index k = 0; k < n; ++k)
            list.push_back(columns->global_to_local(globals[k]));
        });
    std::vector<unsigned int> old_begin, old_column, list;
    old_begin.swap(begin_of_row);
    old_column.swap(column);
    begin_of_row.assign(1, 0);
    for (row = 0; row + 1 < old_begin.size(); ++row)
      {
        list.clear();
        for (unsigned int k = old_begin[row]; k < old_begin[row + 1]; ++k)
          list.push_back(
            columns->global_to_local(nodes.local_to_global(old_column[k])));
        // Sent rows keep their order of global columns, which the owner has.
        if (row < n_own)
          {
            list.insert(list.end(), more[row].begin(), more[row].end());
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
          }
        column.insert(column.end(), list.begin(), list.end());
        begin_of_row.push_back(column.size());
      }
    const unsigned int shift = begin_of_row[n_own] - old_begin[n_own];
    for (Exchange &exchange : sent)
      {
        exchange.begin += shift;
        exchange.end += shift;
      }
    for (const auto &[rank, message] : incoming)
      {
        received.push_back({rank, 0, 0, {}});
        for_each_row(
          message,
          [&](const Index global, const Index *globals, const Index n) {
            const unsigned int own_row = nodes.global_to_local(global);
            const auto         begin   = column.begin() + begin_of_row[own_row];
            const auto         end = column.begin() + begin_of_row[own_row + 1];
            for (Index k = 0; k < n; ++k)
              received.back().entries.push_back(
                std::lower_bound(begin,
                                 end,
                                 columns->global_to_local(globals[k])) -
                column.begin());
          });
      }
  }

  template <int dim>
  void
  NodePattern<dim>::build_tables()
  {
    const auto &nodes = *occupancy.scalar_partitioner();
    column_of_node.resize(occupancy.n_local_nodes());
    for (unsigned int i = 0; i < column_of_node.size(); ++i)
      column_of_node[i] = columns->global_to_local(nodes.local_to_global(i));
    diagonal.resize(occupancy.n_own_nodes());
    for (unsigned int i = 0; i < diagonal.size(); ++i)
      diagonal[i] = entry(i, i);
    scatter.resize(occupancy.locator.n_owned() * n_nodes * n_nodes);
    for (const unsigned int cell : occupancy.active_cells())
      {
        const unsigned int *node  = occupancy.cell_nodes(cell);
        std::uint16_t      *table = &scatter[cell * n_nodes * n_nodes];
        for (unsigned int a = 0; a < n_nodes; ++a)
          for (unsigned int b = 0; b < n_nodes; ++b)
            *table++ = entry(node[a], node[b]) - begin_of_row[node[a]];
      }
  }

  template <int dim>
  unsigned int
  NodePattern<dim>::entry(const unsigned int row_node,
                          const unsigned int column_node) const
  {
    const unsigned int wanted = column_of_node[column_node];
    const auto         begin  = column.begin() + begin_of_row[row_node];
    const auto         end    = column.begin() + begin_of_row[row_node + 1];
    const auto         found  = std::lower_bound(begin, end, wanted);
    Assert(found != end && *found == wanted, ExcInternalError());
    return found - column.begin();
  }

  template <int dim>
  void
  NodePattern<dim>::find_entries(const unsigned int  row_node,
                                 const unsigned int *wanted,
                                 const unsigned int  n,
                                 unsigned int       *entries) const
  {
    unsigned int k = begin_of_row[row_node];
    for (unsigned int i = 0; i < n; ++i)
      {
        for (; column[k] != wanted[i]; ++k)
          AssertIndexRange(k + 1, begin_of_row[row_node + 1]);
        entries[i] = k;
      }
  }

  template <int dim>
  std::shared_ptr<const Utilities::MPI::Partitioner>
  NodePattern<dim>::make_partitioner(const unsigned int components) const
  {
    const auto expand = [&](const IndexSet &set) {
      IndexSet result(components * set.size());
      for (auto interval = set.begin_intervals();
           interval != set.end_intervals();
           ++interval)
        result.add_range(components * *interval->begin(),
                         components * (interval->last() + 1));
      return result;
    };
    return std::make_shared<const Utilities::MPI::Partitioner>(
      expand(columns->locally_owned_range()),
      expand(columns->ghost_indices()),
      columns->get_mpi_communicator());
  }

  template <int dim>
  void
  NodePattern<dim>::add_to_owners(std::vector<double> &values,
                                  const unsigned int   size) const
  {
    const MPI_Comm communicator =
      occupancy.scalar_partitioner()->get_mpi_communicator();
    std::vector<MPI_Request>         requests;
    std::vector<std::vector<double>> buffers;
    for (const Exchange &exchange : received)
      {
        buffers.emplace_back(exchange.entries.size() * size);
        requests.emplace_back();
        AssertThrowMPI(MPI_Irecv(buffers.back().data(),
                                 buffers.back().size(),
                                 MPI_DOUBLE,
                                 exchange.rank,
                                 exchange_tag,
                                 communicator,
                                 &requests.back()));
      }
    for (const Exchange &exchange : sent)
      {
        requests.emplace_back();
        AssertThrowMPI(
          MPI_Isend(values.data() + std::size_t(exchange.begin) * size,
                    (exchange.end - exchange.begin) * size,
                    MPI_DOUBLE,
                    exchange.rank,
                    exchange_tag,
                    communicator,
                    &requests.back()));
      }
    AssertThrowMPI(
      MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE));
    // in the order of ranks, so that sums do not depend on arrival
    for (unsigned int r = 0; r < received.size(); ++r)
      {
        const double *value = buffers[r].data();
        for (const unsigned int entry : received[r].entries)
          for (unsigned int i = 0; i < size; ++i)
            values[std::size_t(entry) * size + i] += *value++;
      }
  }

  template class NodePattern<2>;
  template class NodePattern<3>;
} // namespace seiche
