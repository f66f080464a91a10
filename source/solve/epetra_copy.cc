// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/epetra_copy.h>

#include <Epetra_MpiComm.h>
#include <Epetra_SerialComm.h>

#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Fill a matrix row by row: f(row, indices, values) appends.
    template <typename Function>
    std::unique_ptr<Epetra_CrsMatrix>
    make_matrix(const Epetra_Map      &row_map,
                const Epetra_Map      &column_map,
                const Epetra_Map      &domain_map,
                const std::vector<int> lengths,
                const Function        &f)
    {
      auto result = std::make_unique<Epetra_CrsMatrix>(
        Copy, row_map, column_map, lengths.data(), /*StaticProfile=*/true);
      std::vector<int>    indices;
      std::vector<double> values;
      for (int row = 0; row < row_map.NumMyElements(); ++row)
        {
          indices.clear();
          values.clear();
          f(row, indices, values);
          result->InsertMyValues(row,
                                 indices.size(),
                                 values.data(),
                                 indices.data());
        }
      result->FillComplete(domain_map, row_map);
      result->OptimizeStorage();
      return result;
    }
  } // namespace

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
    return make_matrix(make_map(n_own, rows.n),
                       make_map(pattern.n_columns(), columns.n),
                       make_map(n_own, columns.n),
                       lengths,
                       [&](const int            row,
                           std::vector<int>    &indices,
                           std::vector<double> &values) {
                         for_each_entry(row,
                                        [&](const int column, const double v) {
                                          indices.push_back(column);
                                          values.push_back(v);
                                        });
                       });
  }

  template <int dim>
  std::unique_ptr<Epetra_CrsMatrix>
  mean_component(const BlockMatrix<dim> &matrix)
  {
    const NodePattern<dim> &pattern = matrix.sparsity();
    const Occupancy<dim>   &grid    = matrix.occupancy;
    const unsigned int      n_own   = grid.n_own_nodes();
    const Epetra_Map map(static_cast<int>(n_own), 0, Epetra_SerialComm());
    std::vector<int> lengths(n_own);
    for (unsigned int i = 0; i < n_own; ++i)
      lengths[i] = matrix.is_empty(i) ?
                     1 :
                     pattern.row_begin(i + 1) - pattern.row_begin(i);
    return make_matrix(map,
                       map,
                       map,
                       lengths,
                       [&](const int            row,
                           std::vector<int>    &indices,
                           std::vector<double> &values) {
                         const auto add = [&](const unsigned int k) {
                           const unsigned int column = pattern.column_of(k);
                           if (column >= n_own)
                             return;
                           const unsigned int fixed =
                             grid.fixed_components(row) |
                             grid.fixed_components(column);
                           double       sum = 0.;
                           unsigned int n   = 0;
                           for (unsigned int i = 0; i < dim; ++i)
                             if (!(fixed & (1u << i)))
                               {
                                 sum += matrix.value(k, i, i);
                                 ++n;
                               }
                           const bool on_diagonal =
                             static_cast<int>(column) == row;
                           if (n == 0 && on_diagonal)
                             {
                               sum = matrix.value(k, 0, 0);
                               n   = 1;
                             }
                           if (sum != 0. || on_diagonal)
                             {
                               indices.push_back(column);
                               values.push_back(sum / std::max(n, 1u));
                             }
                         };
                         if (matrix.is_empty(row))
                           add(pattern.diagonal_of(row));
                         else
                           for (unsigned int k = pattern.row_begin(row);
                                k < pattern.row_begin(row + 1);
                                ++k)
                             add(k);
                       });
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

#define INSTANTIATE(dim)                                          \
  template std::unique_ptr<Epetra_CrsMatrix> epetra_copy<dim>(    \
    const BlockMatrix<dim> &,                                     \
    const FieldRange,                                             \
    const FieldRange,                                             \
    const double);                                                \
  template std::unique_ptr<Epetra_CrsMatrix> mean_component<dim>( \
    const BlockMatrix<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
} // namespace seiche
