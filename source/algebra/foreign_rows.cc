// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/foreign_rows.h>

#include <deal.II/base/mpi.templates.h>

#include <algorithm>
#include <map>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    using Index = types::global_dof_index;

    /// Rows on their way: [number of entries, global columns] of each.
    struct Message
    {
      std::vector<Index> columns;
      std::vector<float> blocks;

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &columns &blocks;
      }
    };

    template <int dim>
    void
    append_row(Message                &message,
               const BlockMatrix<dim> &matrix,
               const unsigned int      row)
    {
      const NodePattern<dim> &pattern = matrix.sparsity();
      const unsigned int      begin   = pattern.row_begin(row),
                         end          = pattern.row_begin(row + 1);
      message.columns.push_back(end - begin);
      for (unsigned int k = begin; k < end; ++k)
        {
          message.columns.push_back(
            pattern.global_column(pattern.column_of(k)));
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int r = 0; r < ForeignRows<dim>::n_rows; ++r)
              message.blocks.push_back(r < dim ? matrix.column(k, c)[r] : 0.f);
        }
    }
  } // namespace

  template <int dim>
  ForeignRows<dim>::ForeignRows(const BlockMatrix<dim> &matrix)
    : is_shared(
        Utilities::MPI::n_mpi_processes(
          matrix.occupancy.nodes.partitioner()->get_mpi_communicator()) > 1)
  {
    if (!is_shared)
      return;
    const auto    &nodes        = *matrix.occupancy.nodes.partitioner();
    const auto    &known        = matrix.sparsity().column_layout();
    const MPI_Comm communicator = nodes.get_mpi_communicator();

    std::map<unsigned int, std::vector<Index>> wanted;
    unsigned int next = known.locally_owned_size();
    for (const auto &[rank, n] : known.ghost_targets())
      for (unsigned int i = 0; i < n; ++i)
        wanted[rank].push_back(known.local_to_global(next++));
    std::map<unsigned int, Message> answers;
    for (const auto &[rank, rows] :
         Utilities::MPI::some_to_some(communicator, wanted))
      for (const Index row : rows)
        append_row(answers[rank], matrix, nodes.global_to_local(row));

    constexpr unsigned int                              size = dim * n_rows;
    std::vector<std::pair<unsigned int, const float *>> row; // by column
    // by rank, and so in the order of the columns
    for (const auto &[rank, message] :
         Utilities::MPI::some_to_some(communicator, answers))
      {
        const float *values = message.blocks.data();
        for (std::size_t i = 0; i < message.columns.size();)
          {
            row.clear();
            for (Index n = message.columns[i++]; n > 0; --n, values += size)
              if (const Index global = message.columns[i++];
                  known.in_local_range(global) || known.is_ghost_entry(global))
                row.emplace_back(known.global_to_local(global), values);
            std::sort(row.begin(), row.end());
            for (const auto &[number, block] : row)
              {
                column.push_back(number);
                blocks.insert(blocks.end(), block, block + size);
              }
            begin.push_back(column.size());
          }
      }
  }

  template struct ForeignRows<2>;
  template struct ForeignRows<3>;
} // namespace seiche
