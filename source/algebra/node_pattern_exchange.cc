// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/node_pattern.h>

#include <deal.II/base/mpi.templates.h>

#include <algorithm>
#include <map>

// The part of NodePattern that speaks with other ranks.
namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr int exchange_tag = 4711;

    using Index = types::global_dof_index;

    /// f(global row, its global columns, their number) for the rows of
    /// messages.
    template <typename Messages, typename Function>
    void
    for_each_row(const Messages &messages, const Function &f)
    {
      for (const auto &[rank, message] : messages)
        for (std::size_t i = 0; i < message.size(); i += 2 + message[i + 1])
          f(message[i], message.data() + i + 2, message[i + 1]);
    }
  } // namespace

  template <int dim>
  void
  NodePattern<dim>::exchange_couplings()
  {
    sent.clear();
    received.clear();
    const auto &nodes = *occupancy.nodes.partitioner();
    if (Utilities::MPI::n_mpi_processes(nodes.get_mpi_communicator()) == 1)
      {
        columns = occupancy.nodes.partitioner();
        return;
      }
    const RowMessages incoming = send_ghost_rows();
    number_columns(incoming);
    merge_rows(incoming);
    for (const auto &message : incoming)
      {
        received.push_back({message.first, 0, 0, {}});
        for_each_row(RowMessages{message},
                     [&](const Index  global,
                         const Index *globals,
                         const Index  n) {
                       const unsigned int row = nodes.global_to_local(global);
                       for (Index k = 0; k < n; ++k)
                         received.back().entries.push_back(
                           find(row, columns->global_to_local(globals[k])));
                     });
      }
  }

  template <int dim>
  typename NodePattern<dim>::RowMessages
  NodePattern<dim>::send_ghost_rows()
  {
    const auto  &nodes = *occupancy.nodes.partitioner();
    RowMessages  outgoing;
    unsigned int row = occupancy.nodes.n_own();
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
    return Utilities::MPI::some_to_some(nodes.get_mpi_communicator(), outgoing);
  }

  template <int dim>
  void
  NodePattern<dim>::number_columns(const RowMessages &incoming)
  {
    const auto        &nodes = *occupancy.nodes.partitioner();
    std::vector<Index> ghosts;
    const auto         note = [&](const Index global) {
      if (!nodes.in_local_range(global))
        ghosts.push_back(global);
    };
    for (unsigned int i = occupancy.nodes.n_own();
         i < occupancy.nodes.n_local();
         ++i)
      note(nodes.local_to_global(i));
    for_each_row(incoming,
                 [&](const Index, const Index *globals, const Index n) {
                   std::for_each(globals, globals + n, note);
                 });
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    IndexSet ghost_set(nodes.size());
    ghost_set.add_indices(ghosts.begin(), ghosts.end());
    columns = std::make_shared<const Utilities::MPI::Partitioner>(
      nodes.locally_owned_range(), ghost_set, nodes.get_mpi_communicator());
  }

  template <int dim>
  void
  NodePattern<dim>::merge_rows(const RowMessages &incoming)
  {
    const auto        &nodes = *occupancy.nodes.partitioner();
    const unsigned int n_own = occupancy.nodes.n_own();
    std::vector<std::vector<unsigned int>> more(n_own);
    for_each_row(incoming,
                 [&](const Index global, const Index *globals, const Index n) {
                   auto &list = more[nodes.global_to_local(global)];
                   for (Index k = 0; k < n; ++k)
                     list.push_back(columns->global_to_local(globals[k]));
                 });
    std::vector<unsigned int> old_begin, old_column, list;
    old_begin.swap(begin_of_row);
    old_column.swap(column);
    begin_of_row.assign(1, 0);
    for (unsigned int row = 0; row + 1 < old_begin.size(); ++row)
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
  }

  template <int dim>
  void
  NodePattern<dim>::add_to_owners(std::vector<float> &values,
                                  const unsigned int  size) const
  {
    const MPI_Comm communicator =
      occupancy.nodes.partitioner()->get_mpi_communicator();
    std::vector<MPI_Request>        requests;
    std::vector<std::vector<float>> buffers;
    for (const Exchange &exchange : received)
      {
        buffers.emplace_back(exchange.entries.size() * size);
        requests.emplace_back();
        AssertThrowMPI(MPI_Irecv(buffers.back().data(),
                                 buffers.back().size(),
                                 MPI_FLOAT,
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
                    MPI_FLOAT,
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
        const float *value = buffers[r].data();
        for (const unsigned int entry : received[r].entries)
          for (unsigned int i = 0; i < size; ++i)
            values[std::size_t(entry) * size + i] += *value++;
      }
  }

  template void
  NodePattern<2>::exchange_couplings();
  template void
  NodePattern<3>::exchange_couplings();
  template void
  NodePattern<2>::add_to_owners(std::vector<float> &, const unsigned int) const;
  template void
  NodePattern<3>::add_to_owners(std::vector<float> &, const unsigned int) const;
} // namespace seiche
