// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_ilu_row_h
#define seiche_algebra_ilu_row_h

#include <seiche/algebra/foreign_rows.h>
#include <seiche/utilities/register.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace seiche
{
  /// A block at work: its columns, each in a register.
  template <int dim>
  struct ILUBlock
  {
    static constexpr unsigned int n_rows = ForeignRows<dim>::n_rows;
    using Lanes                          = Register<n_rows>;

    typename Lanes::Doubles column[dim];

    /// From columns that lie @p stride numbers apart; what is behind dim rows
    /// means nothing.
    static ILUBlock
    load(const float *columns, const unsigned int stride)
    {
      ILUBlock block;
      for (unsigned int c = 0; c < dim; ++c)
        block.column[c] = Lanes::load(columns + c * stride);
      return block;
    }

    /// (*this) B of a stored block B.
    ILUBlock
    operator*(const float *B) const
    {
      ILUBlock result;
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
    operator-=(const ILUBlock &other)
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
      dealii::Tensor<2, dim> block;
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
  class ILURow
  {
  public:
    explicit ILURow(const unsigned int n_columns)
      : place(n_columns, none)
    {}

    /// An own row.
    void
    read(const BlockMatrix<dim> &matrix,
         const unsigned int      row,
         const double            diagonal_factor)
    {
      clear();
      const NodePattern<dim> &pattern  = matrix.sparsity();
      const auto              of_entry = [&matrix](const unsigned int entry) {
        return ILUBlock<dim>::load(matrix.column(entry, 0), matrix.n_fields());
      };
      diagonal = of_entry(pattern.diagonal_of(row));
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
            append(row, column, of_entry(k));
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
      for (unsigned int k = rows.begin[number]; k < rows.begin[number + 1]; ++k)
        {
          const auto block =
            ILUBlock<dim>::load(rows.block(k), ForeignRows<dim>::n_rows);
          if (rows.column[k] == row)
            diagonal = block;
          else
            append(row, rows.column[k], block);
        }
      strengthen_diagonal(diagonal_factor);
    }

    /// Subtract L times a stored block from the entry of a column, if there
    /// is one.
    void
    subtract(const unsigned int   row,
             const unsigned int   column,
             const ILUBlock<dim> &L,
             const float         *B)
    {
      if (column == row)
        diagonal -= L * B;
      else if (place[column] != none)
        blocks[column > row][place[column]] -= L * B;
    }

    ILUBlock<dim>              diagonal;
    std::vector<unsigned int>  columns[2]; ///< of L, of U
    std::vector<ILUBlock<dim>> blocks[2];

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
    append(const unsigned int   row,
           const unsigned int   column,
           const ILUBlock<dim> &block)
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

    static constexpr int none = -1;
    std::vector<int>     place; // of a column among blocks, or none
  };
} // namespace seiche

#endif
