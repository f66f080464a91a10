// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_foreign_rows_h
#define seiche_algebra_foreign_rows_h

#include <seiche/algebra/block_matrix.h>

namespace seiche
{
  /**
   * @brief The rows of other ranks' nodes to which own rows couple, as far as
   * they couple among these and own nodes: one layer of overlap.
   */
  template <int dim>
  struct ForeignRows
  {
    /// Numbers of a column of a block, padded as in a register.
    static constexpr unsigned int n_rows = dim == 3 ? 4 : dim;

    /// Fetch them from their owners, displacements only. Collective.
    explicit ForeignRows(const BlockMatrix<dim> &matrix);

    /// Of the entry, column by column.
    const float *
    block(const unsigned int entry) const
    {
      return &blocks[std::size_t(entry) * dim * n_rows];
    }

    const bool is_shared; ///< there are several ranks

    /// [row + 1], in the order of the columns behind the own ones.
    std::vector<unsigned int> begin = {0};
    std::vector<unsigned int> column; ///< numbers of the pattern, ascending
    std::vector<float>        blocks;
  };
} // namespace seiche

#endif
