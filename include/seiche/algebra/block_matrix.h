// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_block_matrix_h
#define seiche_algebra_block_matrix_h

#include <seiche/algebra/cell_matrix.h>
#include <seiche/algebra/node_pattern.h>

#include <deal.II/lac/la_parallel_block_vector.h>

#include <vector>

namespace seiche
{
  /**
   * @brief The system matrix [A G; C D] of doc/theory.md (10.4), stored by
   * pairs of nodes.
   *
   * Fields of a node: dim components of the displacement, then the pressure. An
   * entry of the pattern holds the columns of the displacement, [component]
   * [row field], and, in a second array, the column of the pressure: a product
   * reads each once and fills the vector registers with the rows, and the
   * product with G alone reads a quarter. Rows of nodes away from the fluid are
   * multiples of identity and cost nothing. Numbers are single: products are
   * bound by memory, and all who solve correct by residuals in double
   * precision. (Four Epetra matrices would hold an index for each number, and
   * on several ranks every block twice, as assembled and as owned rows.)
   */
  template <int dim>
  class BlockMatrix
  {
  public:
    using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /// References must outlive the matrix.
    BlockMatrix(const Fill<dim> &fill, const bool with_pressure);

    /// Adapt the pattern to occupancy and ghost faces if need be. Collective.
    void
    reinit();

    /// Grows by one with each new pattern.
    unsigned int
    generation() const
    {
      return pattern_generation;
    }

    void
    set_zero();

    /// Ask for the memory of the cell's entries, to be there when its blocks
    /// are: add_cell() would wait for it.
    void
    prefetch_cell(const unsigned int cell) const;

    /// Add the blocks of an own occupied cell; rows and columns of fixed
    /// components are left out.
    template <int degree>
    void
    add_cell(const unsigned int cell, const CellMatrix<dim, degree> &data);

    /// Add to the entry of two local nodes: a number for each component of the
    /// displacement, and one for the pressure; rows and columns of fixed
    /// components are left out.
    void
    add_pair(const unsigned int entry,
             const unsigned int row,
             const unsigned int column,
             const double       displacement,
             const double       pressure);

    /// Sum over ranks; rows that got nothing become multiples of identity.
    /// Collective.
    void
    compress();

    /// dst = (matrix) src. Collective.
    void
    vmult(BlockVector &dst, const BlockVector &src) const;

    /// force = G pressure [N]. Collective.
    void
    gradient(Vector &force, const Vector &pressure) const;

    bool
    has_pressure() const
    {
      return with_pressure;
    }

    /// Rows a node: dim, or dim + 1 with a pressure.
    unsigned int
    n_fields() const
    {
      return dim + with_pressure;
    }

    /// One number of an entry of the pattern.
    double
    value(const unsigned int entry,
          const unsigned int row_field,
          const unsigned int column_field) const
    {
      const std::size_t n = n_fields(), e = entry;
      return column_field < dim ?
               displacement_columns[(e * dim + column_field) * n + row_field] :
               pressure_column[e * n + row_field];
    }

    /// A column of the displacement, by row fields; one number more may be read
    /// behind it.
    const float *
    column(const unsigned int entry, const unsigned int component) const
    {
      return &displacement_columns[(std::size_t(entry) * dim + component) *
                                   n_fields()];
    }

    /// On the diagonal of an own row.
    double
    diagonal(const unsigned int node, const unsigned int field) const
    {
      return value(pattern.diagonal_of(node), field, field);
    }

    /// True if the own row is a multiple of identity: there is no fluid.
    bool
    is_empty(const unsigned int node) const
    {
      return empty[node];
    }

    const Occupancy<dim> &occupancy;

    const NodePattern<dim> &
    sparsity() const
    {
      return pattern;
    }

  private:
    template <int degree>
    struct CellEntries;

    template <int degree, unsigned int n>
    void
    add_cell_fields(const unsigned int             cell,
                    const CellMatrix<dim, degree> &data);

    /// Add P_row @p value P_column to a block, P that of constraints.
    void
    add_projected(const unsigned int row,
                  const unsigned int column,
                  const double       value,
                  float             *block) const;

    /// The rows of oblique directions are empty: n n^T times the mean diagonal
    /// of the node.
    void
    add_oblique_directions();

    /// Zero diagonals of rows without entries get the largest of their block.
    void
    complete_diagonal();

    template <unsigned int n_rows>
    void
    multiply(BlockVector &dst) const;

    NodePattern<dim>   pattern;
    const bool         with_pressure;
    unsigned int       pattern_generation = 0;
    std::vector<float> displacement_columns; // [entry][component][row field]
    std::vector<float> pressure_column;      // [entry][row field]
    std::vector<char>  empty;                // [own node]
    // source of a product with its ghost columns, all fields and pressure
    mutable Vector source, pressure_source;
  };
} // namespace seiche

#endif
