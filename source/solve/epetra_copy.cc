// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/epetra_copy.h>

#include <Epetra_MpiComm.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix>
  epetra_copy(const BlockMatrix<dim> &matrix,
              const FieldRange        rows,
              const FieldRange        columns,
              const double            factor)
  {
    const NodePattern<dim> &pattern = matrix.sparsity();
    const Epetra_MpiComm    communicator(
      matrix.occupancy.scalar_partitioner()->get_mpi_communicator());
    const unsigned int n_own    = matrix.occupancy.n_own_nodes();
    const auto         make_map = [&](const unsigned int n_nodes,
                              const unsigned int n_fields) {
      std::vector<int> indices;
      indices.reserve(n_nodes * n_fields);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < n_fields; ++c)
          indices.push_back(pattern.global_column(i) * n_fields + c);
      return Epetra_Map(-1, indices.size(), indices.data(), 0, communicator);
    };
    const auto is_stored = [&](const unsigned int entry,
                               const unsigned int r,
                               const unsigned int c) {
      return matrix.value(entry, rows.first + r, columns.first + c) != 0.;
    };
    const bool square = rows.first == columns.first && rows.n == columns.n;

    const auto for_each_entry = [&](const int row, const auto &f) {
      const unsigned int node = row / rows.n, r = row % rows.n;
      const auto         visit = [&](const unsigned int k) {
        for (unsigned int c = 0; c < columns.n; ++c)
          if (is_stored(k, r, c) ||
              (square && r == c && pattern.column_of(k) == node))
            f(pattern.column_of(k) * columns.n + c,
              factor * matrix.value(k, rows.first + r, columns.first + c));
      };
      if (matrix.is_empty(node))
        visit(pattern.diagonal_of(node));
      else
        for (unsigned int k = pattern.row_begin(node);
             k < pattern.row_begin(node + 1);
             ++k)
          visit(k);
    };
    std::vector<int> lengths(n_own * rows.n, 0);
    for (unsigned int row = 0; row < lengths.size(); ++row)
      for_each_entry(row, [&](const int, const double) { ++lengths[row]; });
    auto result =
      std::make_unique<Epetra_CrsMatrix>(Copy,
                                         make_map(n_own, rows.n),
                                         make_map(pattern.n_columns(),
                                                  columns.n),
                                         lengths.data(),
                                         /*StaticProfile=*/true);
    std::vector<int>    indices;
    std::vector<double> values;
    for (unsigned int row = 0; row < lengths.size(); ++row)
      {
        indices.clear();
        values.clear();
        for_each_entry(row, [&](const int column, const double value) {
          indices.push_back(column);
          values.push_back(value);
        });
        result->InsertMyValues(row,
                               indices.size(),
                               values.data(),
                               indices.data());
      }
    result->FillComplete(make_map(n_own, columns.n), make_map(n_own, rows.n));
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
    const BlockMatrix<dim> &,                                  \
    const FieldRange,                                          \
    const FieldRange,                                          \
    const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
} // namespace seiche
