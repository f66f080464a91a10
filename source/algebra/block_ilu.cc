// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/block_ilu.h>
#include <seiche/algebra/foreign_rows.h>
#include <seiche/utilities/register.h>
#include <seiche/utilities/storage.h>

#include <deal.II/base/tensor.h>

#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// A block at work: its columns, each in a register.
    template <int dim>
    struct Columns
    {
      static constexpr unsigned int n_rows = BlockILU<dim>::n_rows;
      using Lanes                          = Register<n_rows>;

      typename Lanes::Doubles column[dim];

      /// (*this) B of a stored block B.
      Columns
      operator*(const float *B) const
      {
        Columns result;
        for (unsigned int c = 0; c < dim; ++c)
          {
            const float *b   = B + c * n_rows;
            result.column[c] = column[0] * static_cast<double>(b[0]);
            for (unsigned int j = 1; j < dim; ++j)
              result.column[c] += column[j] * static_cast<double>(b[j]);
          }
        return result;
      }

      void
      operator-=(const Columns &other)
      {
        for (unsigned int c = 0; c < dim; ++c)
          column[c] -= other.column[c];
      }

      void
      store(float *to) const
      {
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int r = 0; r < dim; ++r)
            to[c * n_rows + r] = static_cast<float>(column[c][r]);
      }

      void
      store_inverse(float *to) const
      {
        Tensor<2, dim> block;
        for (unsigned int r = 0; r < dim; ++r)
          for (unsigned int c = 0; c < dim; ++c)
            block[r][c] = column[c][r];
        block = invert(block);
        for (unsigned int r = 0; r < dim; ++r)
          for (unsigned int c = 0; c < dim; ++c)
            to[c * n_rows + r] = static_cast<float>(block[r][c]);
      }
    };

    /// The row at work: entries below and above the diagonal, and where a
    /// column is found among them.
    template <int dim>
    struct WorkRow
    {
      static constexpr int none = -1;

      explicit WorkRow(const unsigned int n_columns)
        : place(n_columns, none)
      {}

      /// An own row.
      void
      read(const BlockMatrix<dim> &matrix,
           const unsigned int      row,
           const double            diagonal_factor)
      {
        clear();
        const NodePattern<dim> &pattern = matrix.sparsity();
        diagonal = of_entry(matrix, pattern.diagonal_of(row));
        strengthen_diagonal(diagonal_factor);
        if (matrix.is_empty(row))
          return;
        const unsigned int n_own = matrix.occupancy.nodes.n_own();
        for (unsigned int k = pattern.row_begin(row);
             k < pattern.row_begin(row + 1);
             ++k)
          {
            const unsigned int column = pattern.column_of(k);
            if (column != row && !(column < n_own && matrix.is_empty(column)))
              append(row, column, of_entry(matrix, k));
          }
      }

      /// Row @p number of those of other ranks.
      void
      read(const ForeignRows<dim> &rows,
           const unsigned int      number,
           const unsigned int      row,
           const double            diagonal_factor)
      {
        clear();
        for (unsigned int k = rows.begin[number]; k < rows.begin[number + 1];
             ++k)
          if (rows.column[k] == row)
            {
              diagonal = of_block(rows.block(k));
              strengthen_diagonal(diagonal_factor);
            }
          else
            append(row, rows.column[k], of_block(rows.block(k)));
      }

      /// Subtract L times a stored block from the entry of a column, if there
      /// is one.
      void
      subtract(const unsigned int  row,
               const unsigned int  column,
               const Columns<dim> &L,
               const float        *B)
      {
        if (column == row)
          diagonal -= L * B;
        else if (place[column] != none)
          blocks[column > row][place[column]] -= L * B;
      }

      Columns<dim>              diagonal;
      std::vector<unsigned int> columns[2]; ///< of L, of U
      std::vector<Columns<dim>> blocks[2];

    private:
      void
      clear()
      {
        for (unsigned int side = 0; side < 2; ++side)
          {
            for (const unsigned int column : columns[side])
              place[column] = none;
            columns[side].clear();
            blocks[side].clear();
          }
      }

      void
      append(const unsigned int  row,
             const unsigned int  column,
             const Columns<dim> &block)
      {
        const unsigned int side = column > row;
        place[column]           = blocks[side].size();
        columns[side].push_back(column);
        blocks[side].push_back(block);
      }

      void
      strengthen_diagonal(const double factor)
      {
        for (unsigned int c = 0; c < dim; ++c)
          diagonal.column[c][c] *= factor;
      }

      static Columns<dim>
      of_entry(const BlockMatrix<dim> &matrix, const unsigned int entry)
      {
        // rows beyond those of the displacement mean nothing
        Columns<dim> block;
        for (unsigned int c = 0; c < dim; ++c)
          block.column[c] = Columns<dim>::Lanes::load(matrix.column(entry, c));
        return block;
      }

      static Columns<dim>
      of_block(const float *values)
      {
        Columns<dim> block;
        for (unsigned int c = 0; c < dim; ++c)
          block.column[c] =
            Columns<dim>::Lanes::load(values + c * Columns<dim>::n_rows);
        return block;
      }

      std::vector<int> place;
    };
  } // namespace

  template <int dim>
  void
  BlockILU<dim>::initialize(const BlockMatrix<dim> &matrix,
                            const double            diagonal_factor)
  {
    const NodePattern<dim> &pattern = matrix.sparsity();
    const ForeignRows<dim>  foreign(matrix);
    const unsigned int      n_own = matrix.occupancy.nodes.n_own();
    const unsigned int      n     = n_own + foreign.begin.size() - 1;
    overlaps                      = foreign.is_shared;
    if (overlaps)
      extended.reinit(pattern.make_partitioner(dim));
    // half of the couplings: the pattern is symmetric
    const std::size_t n_couplings =
      (pattern.row_begin(n_own) + foreign.column.size() - n) / 2;
    for (Triangle *triangle : {&lower, &upper})
      {
        triangle->begin.assign(1, 0);
        make_room(triangle->column, n_couplings);
        make_room(triangle->blocks, n_couplings * size);
      }
    inverses.assign(n * size, 0.f);

    const auto append = [](Triangle                        &triangle,
                           const std::vector<unsigned int> &columns,
                           const std::vector<Columns<dim>> &blocks) {
      const std::size_t first = triangle.blocks.size();
      triangle.column.insert(triangle.column.end(),
                             columns.begin(),
                             columns.end());
      triangle.blocks.resize(first + blocks.size() * size);
      for (unsigned int k = 0; k < blocks.size(); ++k)
        blocks[k].store(&triangle.blocks[first + k * size]);
      triangle.begin.push_back(triangle.column.size());
    };

    WorkRow<dim> work(n);
    for (unsigned int row = 0; row < n; ++row)
      {
        if (row < n_own)
          work.read(matrix, row, diagonal_factor);
        else
          work.read(foreign, row - n_own, row, diagonal_factor);
        // eliminate with the rows before
        for (unsigned int l = 0; l < work.columns[0].size(); ++l)
          {
            const unsigned int other = work.columns[0][l];
            const Columns<dim> L = work.blocks[0][l] * &inverses[other * size];
            work.blocks[0][l]    = L;
            for (unsigned int u = upper.begin[other];
                 u < upper.begin[other + 1];
                 ++u)
              work.subtract(row,
                            upper.column[u],
                            L,
                            &upper.blocks[std::size_t(u) * size]);
          }
        work.diagonal.store_inverse(&inverses[row * size]);
        append(lower, work.columns[0], work.blocks[0]);
        append(upper, work.columns[1], work.blocks[1]);
      }
  }

  template <int dim>
  void
  BlockILU<dim>::vmult(Vector &x, const Vector &b) const
  {
    const std::size_t n = b.locally_owned_size();
    if (!overlaps)
      {
        if (&x != &b)
          std::copy(b.begin(), b.begin() + n, x.begin());
        return solve(x.begin());
      }
    std::copy(b.begin(), b.begin() + n, extended.begin());
    extended.update_ghost_values();
    solve(extended.begin());
    std::copy(extended.begin(), extended.begin() + n, x.begin());
    extended.zero_out_ghost_values();
  }

  template <int dim>
  void
  BlockILU<dim>::solve(double *to) const
  {
    using Lanes          = Register<n_rows>;
    using Rows           = typename Lanes::Doubles;
    const unsigned int n = lower.begin.size() - 1;

    // one sum for each column: the additions need not wait for each other
    const auto add_block =
      [&](Rows *sum, const Triangle &triangle, const std::size_t k) {
        const double *other = to + triangle.column[k] * dim;
        for (unsigned int j = 0; j < dim; ++j)
          sum[j] +=
            Lanes::load(&triangle.blocks[k * size + j * n_rows]) * other[j];
      };
    for (unsigned int row = 0; row < n; ++row)
      {
        Rows sum[dim] = {};
        for (unsigned int k = lower.begin[row]; k < lower.begin[row + 1]; ++k)
          add_block(sum, lower, k);
        for (unsigned int j = 1; j < dim; ++j)
          sum[0] += sum[j];
        for (unsigned int i = 0; i < dim; ++i)
          to[row * dim + i] -= sum[0][i];
      }
    for (unsigned int row = n; row-- > 0;)
      {
        Rows sum[dim] = {};
        for (unsigned int k = upper.begin[row + 1]; k-- > upper.begin[row];)
          add_block(sum, upper, k);
        for (unsigned int j = 1; j < dim; ++j)
          sum[0] += sum[j];
        Rows solution = {};
        for (unsigned int j = 0; j < dim; ++j)
          solution += Lanes::load(&inverses[row * size + j * n_rows]) *
                      (to[row * dim + j] - sum[0][j]);
        for (unsigned int i = 0; i < dim; ++i)
          to[row * dim + i] = solution[i];
      }
  }

  template <int dim>
  double
  BlockILU<dim>::growth(const BlockMatrix<dim> &matrix) const
  {
    Vector test(matrix.occupancy.nodes.vector_partitioner());
    for (unsigned int i = 0; i < test.locally_owned_size(); ++i)
      test.local_element(i) = matrix.diagonal(i / dim, i % dim);
    vmult(test, test);
    // not linfty_norm(), which passes over what is not a number
    double largest = 0.;
    for (const double value : test)
      largest = std::isfinite(value) ? std::max(largest, std::abs(value)) :
                                       std::numeric_limits<double>::infinity();
    return Utilities::MPI::max(largest, test.get_mpi_communicator());
  }

  template class BlockILU<2>;
  template class BlockILU<3>;
} // namespace seiche
