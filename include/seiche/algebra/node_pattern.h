// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_algebra_node_pattern_h
#define seiche_algebra_node_pattern_h

#include <seiche/grid/fill.h>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace seiche
{
  /**
   * @brief Which nodes are coupled: compressed rows, and how ranks add them up.
   *
   * Rows are the own and ghost nodes of the compact numbering (NodeNumbering).
   * Columns are own nodes, then all others that a row couples with, in the
   * order of columns(). A pattern lives until the numbering changes or a cell
   * becomes occupied, or a ghost face appears, that is not in it. Each rank
   * assembles into rows of own and of ghost nodes; add_to_owners() sends the
   * latter, which are stored by owner, away as they lie. (A rank's own rows
   * know the columns of all ranks.)
   */
  template <int dim>
  class NodePattern
  {
  public:
    /// The reference must outlive the pattern.
    explicit NodePattern(const Fill<dim> &fill);

    /// Adapt to occupancy and ghost faces if need be; true if it changed.
    /// Collective.
    bool
    reinit();

    /// Entries of a row: [row_begin(i), row_begin(i + 1)).
    unsigned int
    row_begin(const unsigned int row) const
    {
      return begin_of_row[row];
    }

    /// Of all rows; own rows come first.
    unsigned int
    n_entries() const
    {
      return column.size();
    }

    /// Column of an entry; ascending within a row.
    unsigned int
    column_of(const unsigned int entry) const
    {
      return column[entry];
    }

    /// Entry on the diagonal of an own row.
    unsigned int
    diagonal_of(const unsigned int row) const
    {
      return diagonal[row];
    }

    /// Entry of the pair of local nodes, which must be coupled.
    unsigned int
    entry(const unsigned int row_node, const unsigned int column_node) const;

    /// Entries of a row at @p n columns, which ascend and are coupled to it.
    void
    find_entries(const unsigned int  row_node,
                 const unsigned int *columns,
                 const unsigned int  n,
                 unsigned int       *entries) const;

    /// Column of a local node.
    unsigned int
    column_of_local(const unsigned int node) const
    {
      return column_of_node[node];
    }

    /// [a][b]: entry of nodes a and b of an own active cell, counted from the
    /// first of row a.
    const std::uint16_t *
    cell_entries(const unsigned int cell) const
    {
      return &scatter[std::size_t(cell) * n_nodes * n_nodes];
    }

    /// Layout of a vector over the columns with @p components entries a node.
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner>
    make_partitioner(const unsigned int components) const;

    /// Own nodes, then the others that own rows couple to.
    const dealii::Utilities::MPI::Partitioner &
    column_layout() const
    {
      return *columns;
    }

    /// Global node of each column.
    dealii::types::global_dof_index
    global_column(const unsigned int index) const
    {
      return columns->local_to_global(index);
    }
    unsigned int
    n_columns() const
    {
      return columns->locally_owned_size() + columns->n_ghost_indices();
    }

    /// Add ghost rows, @p size numbers an entry, to their owners'. Collective.
    void
    add_to_owners(std::vector<float> &values, const unsigned int size) const;

    /// Of the elements that couple across the face: the higher one.
    unsigned int
    degree(const GhostFace &face) const;

    const Fill<dim>      &fill;
    const Occupancy<dim> &occupancy;

  private:
    /// Rows of one rank that another assembles: sent or received as one run.
    struct Exchange
    {
      unsigned int              rank;
      unsigned int              begin, end; ///< entries sent
      std::vector<unsigned int> entries;    ///< where the received are added
    };

    bool
    covers(const std::vector<GhostFace> &faces) const;

    /// Number of a face, from the finer of its cells.
    std::size_t
    face_index(const unsigned int lower,
               const unsigned int upper,
               const unsigned int direction) const;

    /// Coupled nodes of each local node, from the cells and faces of this
    /// rank, in the local numbering. Local.
    void
    collect_couplings();

    /// From local to column numbers, with what other ranks couple. Collective.
    void
    exchange_couplings();

    /// By rank: global row, number of columns, global columns, and so on.
    using RowMessages =
      std::map<unsigned int, std::vector<dealii::types::global_dof_index>>;

    /// Ghost rows to their owners; what was received. Collective.
    RowMessages
    send_ghost_rows();

    /// `columns`: own nodes, then all others that rows couple to. Collective.
    void
    number_columns(const RowMessages &incoming);

    /// All rows in the numbers of `columns`, own rows with what was received.
    void
    merge_rows(const RowMessages &incoming);

    /// Entry of a row with this column number.
    unsigned int
    find(const unsigned int row_node, const unsigned int column_number) const;

    void
    build_tables();

    const unsigned int         n_nodes; ///< of a cell
    unsigned int               numbering_generation = 0;
    std::vector<unsigned int>  begin_of_row; // [n_local + 1]
    std::vector<unsigned int>  column;
    std::vector<unsigned int>  diagonal;       // [n_own_nodes]
    std::vector<unsigned int>  column_of_node; // [n_local]
    std::vector<std::uint16_t> scatter;        // [cell][a][b]
    std::vector<unsigned char> covered_cells;  // degree [own cell]
    std::vector<unsigned char> covered_faces;  // degree, by face_index()
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> columns;
    std::vector<Exchange>                                      sent, received;
  };
} // namespace seiche

#endif
