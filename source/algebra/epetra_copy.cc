// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/epetra_copy.h>

#include <Epetra_MpiComm.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Entries by row: how many, their local columns, their values.
    struct Entries
    {
      std::vector<int>    lengths, columns;
      std::vector<double> values;
    };

    template <int dim>
    Entries
    collect(const BlockMatrix<dim> &matrix,
            const FieldRange        rows,
            const FieldRange        columns)
    {
      const NodePattern<dim> &pattern = matrix.sparsity();
      const bool square = rows.first == columns.first && rows.n == columns.n;
      Entries    result;
      for (unsigned int node = 0; node < matrix.occupancy.nodes.n_own(); ++node)
        for (unsigned int r = 0; r < rows.n; ++r)
          {
            const std::size_t before = result.columns.size();
            const auto        visit  = [&](const unsigned int entry) {
              const unsigned int column = pattern.column_of(entry);
              for (unsigned int c = 0; c < columns.n; ++c)
                {
                  const double value =
                    matrix.value(entry, rows.first + r, columns.first + c);
                  if (value == 0. && !(square && column == node && r == c))
                    continue;
                  result.columns.push_back(column * columns.n + c);
                  result.values.push_back(value);
                }
            };
            if (matrix.is_empty(node))
              visit(pattern.diagonal_of(node));
            else
              for (unsigned int k = pattern.row_begin(node);
                   k < pattern.row_begin(node + 1);
                   ++k)
                visit(k);
            result.lengths.push_back(result.columns.size() - before);
          }
      return result;
    }
  } // namespace

  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix>
  epetra_copy(const BlockMatrix<dim> &matrix,
              const FieldRange        rows,
              const FieldRange        columns)
  {
    const NodePattern<dim> &pattern = matrix.sparsity();
    const Epetra_MpiComm    communicator(
      matrix.occupancy.nodes.partitioner()->get_mpi_communicator());
    const unsigned int n_own    = matrix.occupancy.nodes.n_own();
    const auto         make_map = [&](const unsigned int n_nodes,
                              const unsigned int n_fields) {
      std::vector<int> indices;
      indices.reserve(n_nodes * n_fields);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < n_fields; ++c)
          indices.push_back(pattern.global_column(i) * n_fields + c);
      return Epetra_Map(-1, indices.size(), indices.data(), 0, communicator);
    };
    const Epetra_Map row_map    = make_map(n_own, rows.n);
    const Epetra_Map domain_map = make_map(n_own, columns.n);
    Entries          entries    = collect(matrix, rows, columns);
    auto             result =
      std::make_unique<Epetra_CrsMatrix>(Copy,
                                         row_map,
                                         make_map(pattern.n_columns(),
                                                  columns.n),
                                         entries.lengths.data(),
                                         /*StaticProfile=*/true);
    std::size_t begin = 0;
    for (unsigned int row = 0; row < entries.lengths.size(); ++row)
      {
        result->InsertMyValues(row,
                               entries.lengths[row],
                               &entries.values[begin],
                               &entries.columns[begin]);
        begin += entries.lengths[row];
      }
    result->FillComplete(domain_map, row_map);
    result->OptimizeStorage();
    return result;
  }

  double &
  diagonal_entry(const Epetra_CrsMatrix &matrix, const int row)
  {
    int     n;
    double *values;
    int    *columns;
    matrix.ExtractMyRowView(row, n, values, columns);
    const int *found = std::lower_bound(columns, columns + n, row);
    Assert(found != columns + n && *found == row, ExcInternalError());
    return values[found - columns];
  }

#define INSTANTIATE(dim)                                       \
  template std::unique_ptr<Epetra_CrsMatrix> epetra_copy<dim>( \
    const BlockMatrix<dim> &, const FieldRange, const FieldRange);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
