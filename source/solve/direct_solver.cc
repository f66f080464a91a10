// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/direct_solver.h>

#include <Amesos.h>
#include <Epetra_LinearProblem.h>
#include <Epetra_Vector.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Rows and columns of all blocks in one map: velocity first.
    std::vector<int>
    global_ids(const Epetra_Map &map, const int offset)
    {
      std::vector<int> ids(map.MyGlobalElements(),
                           map.MyGlobalElements() + map.NumMyElements());
      for (int &id : ids)
        id += offset;
      return ids;
    }

    void
    append_block(const Epetra_CrsMatrix &block,
                 const int               row_offset,
                 const int               column_offset,
                 Epetra_CrsMatrix       &monolithic)
    {
      std::vector<int> columns;
      for (int i = 0; i < block.NumMyRows(); ++i)
        {
          int     n;
          double *values;
          int    *indices;
          block.ExtractMyRowView(i, n, values, indices);
          columns.resize(n);
          for (int k = 0; k < n; ++k)
            columns[k] = block.GCID(indices[k]) + column_offset;
          monolithic.InsertGlobalValues(block.GRID(i) + row_offset,
                                        n,
                                        values,
                                        columns.data());
        }
    }
  } // namespace

  template <int dim>
  bool
  solve_directly(const BlockMatrix<dim>                       &matrix,
                 const bool                                    closed,
                 typename BlockMatrix<dim>::BlockVector       &solution,
                 const typename BlockMatrix<dim>::BlockVector &right_hand_side)
  {
    using Matrix                = BlockMatrix<dim>;
    const Epetra_CrsMatrix &A   = matrix.block(Matrix::uu);
    const int               n_u = A.NumGlobalRows();
    std::vector<int>        ids = global_ids(A.RowMap(), 0);
    if (matrix.has_pressure())
      {
        const auto more = global_ids(matrix.block(Matrix::pp).RowMap(), n_u);
        ids.insert(ids.end(), more.begin(), more.end());
      }
    const Epetra_Map map(-1, ids.size(), ids.data(), 0, A.Comm());
    Epetra_CrsMatrix monolithic(Copy, map, 0);
    append_block(A, 0, 0, monolithic);
    if (matrix.has_pressure())
      {
        append_block(matrix.block(Matrix::up), 0, n_u, monolithic);
        append_block(matrix.block(Matrix::pu), n_u, 0, monolithic);
        append_block(matrix.block(Matrix::pp), n_u, n_u, monolithic);
      }
    monolithic.FillComplete();
    if (closed && map.MyGID(n_u))
      {
        const int           pinned = n_u;
        double              value;
        int                 n, index;
        std::vector<double> values(monolithic.NumGlobalEntries(pinned));
        std::vector<int>    indices(values.size());
        monolithic.ExtractGlobalRowCopy(
          pinned, values.size(), n, values.data(), indices.data());
        index =
          std::find(indices.begin(), indices.end(), pinned) - indices.begin();
        value = 2. * values[index];
        monolithic.ReplaceGlobalValues(pinned, 1, &value, &pinned);
      }

    Epetra_Vector x(map), b(map);
    std::size_t   k = 0;
    for (unsigned int block = 0; block < right_hand_side.n_blocks(); ++block)
      for (unsigned int i = 0;
           i < right_hand_side.block(block).locally_owned_size();
           ++i)
        b[k++] = right_hand_side.block(block).local_element(i);

    Epetra_LinearProblem                     problem(&monolithic, &x, &b);
    const std::unique_ptr<Amesos_BaseSolver> solver(
      Amesos().Create("Amesos_Klu", problem));
    const bool success = solver->SymbolicFactorization() == 0 &&
                         solver->NumericFactorization() == 0 &&
                         solver->Solve() == 0;
    double norm = 0.;
    x.Norm2(&norm);
    k = 0;
    for (unsigned int block = 0; block < solution.n_blocks(); ++block)
      for (unsigned int i = 0; i < solution.block(block).locally_owned_size();
           ++i)
        solution.block(block).local_element(i) = x[k++];
    return success && std::isfinite(norm);
  }

#define INSTANTIATE(dim)                      \
  template bool solve_directly<dim>(          \
    const BlockMatrix<dim> &,                 \
    const bool,                               \
    typename BlockMatrix<dim>::BlockVector &, \
    const typename BlockMatrix<dim>::BlockVector &);
  INSTANTIATE(2)
  INSTANTIATE(3)
} // namespace seiche
