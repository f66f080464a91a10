// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_block_matrix_h
#define seiche_solve_block_matrix_h

#include <seiche/formulation/cell_data.h>
#include <seiche/formulation/ghost_penalty.h>
#include <seiche/grid/fill.h>

#include <deal.II/lac/la_parallel_block_vector.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_Export.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace seiche
{
  /// Diagonal entry of an own row of a square block. (Epetra keeps own columns
  /// first and in the order of the rows, so that both have one local index; its
  /// ExtractDiagonalCopy searches global indices, which took 9 % of a 3D step.)
  double &
  diagonal_entry(const Epetra_CrsMatrix &matrix, const int row);

  /**
   * @brief The system matrix [A G; C D] as four Trilinos (Epetra) matrices.
   *
   * Rows and columns of the velocity block are dim*node + component, of the
   * pressure block node, in the compact numbering. All four share one pattern
   * of nodes, kept for the active cells and the faces near the surface until
   * the numbering changes or a ghost face outside the pattern appears. Cell
   * matrices are written straight into the value arrays through a scatter
   * table. Each rank assembles rows of own and ghost nodes; compress() adds
   * the latter to their owners' (with one rank both are the same matrix).
   */
  template <int dim>
  class BlockMatrix
  {
  public:
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    enum Block : unsigned int
    {
      uu = 0,
      up = 1,
      pu = 2,
      pp = 3
    };

    /// References must outlive the matrix.
    BlockMatrix(const Occupancy<dim> &occupancy, const bool with_pressure);

    /// Adapt the pattern to occupancy and ghost faces if need be. Collective.
    void
    reinit(const Fill<dim> &fill);

    /// Grows by one with each new pattern.
    unsigned int
    generation() const
    {
      return pattern_generation;
    }

    void
    set_zero();

    /// Add the blocks of an own occupied cell; rows and columns of fixed
    /// components are left out.
    void
    add_cell(const unsigned int cell, const CellData<dim> &data);

    /// Add B times a coefficient for each velocity component, and one for the
    /// pressure.
    void
    add_face(const GhostFaceMatrix<dim> &face,
             const double                velocity_coefficient,
             const double                pressure_coefficient);

    /// Sum over ranks; rows that got nothing become multiples of identity.
    /// Collective.
    void
    compress();

    void
    vmult(BlockVector &dst, const BlockVector &src) const;

    /// A block with its own rows only.
    const Epetra_CrsMatrix &
    block(const Block b) const
    {
      return *blocks[b].system;
    }

    bool
    has_pressure() const
    {
      return with_pressure;
    }

    const Occupancy<dim> &occupancy;

  private:
    static constexpr unsigned int n_nodes = CellData<dim>::n_nodes;

    struct Matrices
    {
      std::unique_ptr<Epetra_CrsMatrix> assembled; // own and ghost rows
      std::unique_ptr<Epetra_CrsMatrix> owned;     // empty with one rank
      Epetra_CrsMatrix                 *system = nullptr;
      double                           *values = nullptr; // of assembled
    };

    void
    build_pattern(const Fill<dim> &fill);
    void
    build_scatter();
    void
    build_matrices();
    bool
    pattern_covers(const std::vector<GhostFace> &faces) const;

    /// Number of a face, from the finer of its cells.
    std::size_t
    face_index(const unsigned int lower,
               const unsigned int upper,
               const unsigned int direction) const;

    /// Position of column node @p column in row node @p row.
    unsigned int
    position(const unsigned int row, const unsigned int column) const;

    const bool   with_pressure;
    unsigned int pattern_generation   = 0;
    unsigned int numbering_generation = 0;

    std::vector<unsigned int>  row_begin; // [n_local_nodes + 1]
    std::vector<unsigned int>  columns;   // local nodes, ascending in each row
    std::vector<char>          covered_faces; // by face_index()
    std::vector<std::uint16_t> scatter;       // [cell][a][b] position in row a
    std::array<Matrices, 4>    blocks;
    std::unique_ptr<Epetra_Export> node_export, component_export;
    mutable BlockVector            scratch;
  };
} // namespace seiche

#endif
