// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/block_ilu.h>
#include <seiche/algebra/ilu_row.h>
#include <seiche/utilities/storage.h>

#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  BlockILU<dim>::initialize(const BlockMatrix<dim> &matrix,
                            const ForeignRows<dim> &foreign,
                            const double            diagonal_factor)
  {
    const NodePattern<dim> &pattern = matrix.sparsity();
    const unsigned int      n_own   = matrix.occupancy.nodes.n_own();
    const unsigned int      n       = n_own + foreign.begin.size() - 1;
    overlaps                        = foreign.is_shared;
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

    const auto append = [](Triangle                         &triangle,
                           const std::vector<unsigned int>  &columns,
                           const std::vector<ILUBlock<dim>> &blocks) {
      const std::size_t first = triangle.blocks.size();
      triangle.column.insert(triangle.column.end(),
                             columns.begin(),
                             columns.end());
      triangle.blocks.resize(first + blocks.size() * size);
      for (unsigned int k = 0; k < blocks.size(); ++k)
        blocks[k].store(&triangle.blocks[first + k * size]);
      triangle.begin.push_back(triangle.column.size());
    };

    ILURow<dim> work(n);
    for (unsigned int row = 0; row < n; ++row)
      {
        if (row < n_own)
          work.read(matrix, row, diagonal_factor);
        else
          work.read(foreign, row - n_own, row, diagonal_factor);
        // eliminate with the rows before
        for (unsigned int l = 0; l < work.columns[0].size(); ++l)
          {
            const unsigned int  other = work.columns[0][l];
            const ILUBlock<dim> L = work.blocks[0][l] * &inverses[other * size];
            work.blocks[0][l]     = L;
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
