// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_mass_matrix_h
#define seiche_transfer_mass_matrix_h

#include <seiche/grid/cell_materials.h>
#include <seiche/grid/fill.h>
#include <seiche/grid/grid_state.h>

namespace seiche
{
  /**
   * @brief The mass matrix of the points, M_ab = sum_p m_p N_a(x_p) N_b(x_p)
   * (doc/theory.md (7.2), (7.2a)).
   *
   * Nodal velocities v with M v = sum_p m_p N v_p are the field closest to the
   * points' velocities: exact where these belong to the space of the elements,
   * which a lumped mass is not. The ghost
   * penalty on velocities couples nodes of little mass near the surface to
   * their neighbours.
   */
  template <int dim>
  class MassMatrix
  {
  public:
    /// A vector field: block 0 are the values v of the nodes, block 1 the w of
    /// doc/theory.md (7.2a), which points bring to the cells where a component
    /// is zero; without a block 1 w is zero.
    using Vector = typename GridState<dim>::Vector;
    using Field  = typename GridState<dim>::BlockVector;

    /// @p unseen: block 1, or empty.
    static Field
    field(const Vector &seen, const Vector &unseen);

    /// Of the points where they are. The density of @p materials scales the
    /// ghost penalty (@p ghost_penalty: with it or without). @p masses_of_linear_cells [kg]:
    /// of the nodes, which stand for the points of these cells, or null.
    /// Collective.
    MassMatrix(const PointCloud<dim>    &points,
               const Fill<dim>          &fill,
               const CellMaterials<dim> &materials,
               const bool                ghost_penalty,
               const Field              *masses_of_linear_cells);

    /// Add sum_p m_p N v_p of a vector column of the points [dim] to dst,
    /// without lumped cells. Collective.
    void
    add_right_hand_side(const PointColumn column, Field &dst) const;

    /// dst = M src; rows without mass are identity. Collective.
    void
    vmult(Field &dst, const Field &src) const;

    /// The solution of M v = b by conjugate gradients from the value of v;
    /// throws NumericalError. Collective.
    void
    solve(Field &v, const Field &b) const;

    /// v <- v + M_L^-1 (b - M v), @p n_times: the series of Hammerquist and
    /// Nairn (2017) and Nairn (2021) for M^-1, doc/theory.md (7.4). @p lumped:
    /// masses of the nodes by component. Collective.
    void
    expand(Field             &v,
           const Field       &b,
           const Field       &lumped,
           const unsigned int n_times) const;

  private:
    /// A multiple of a symmetric matrix on some local nodes.
    struct Block
    {
      std::vector<unsigned int> nodes;
      std::size_t               matrix; // its place in matrices
      double                    factor;
    };

    /// A cell where components are zero: at the element's own nodes.
    struct EdgeCell
    {
      unsigned int        cell;
      std::vector<double> values;
    };

    template <int degree>
    void
    collect_cells();
    template <int degree>
    void
    collect_faces(const CellMaterials<dim> &materials);
    bool
    is_lumped(const unsigned int cell) const
    {
      return linear_masses != nullptr && occupancy.degree(cell) == 1;
    }

    template <int degree>
    void
    sum_points(const PointColumn column, Field &dst) const;

    template <int degree>
    void
    add_edge_cells(Field &dst, const Field &src) const;

    template <int degree>
    void
    add_diagonals_of_edge_cells(Field &diagonal) const;

    void
    invert_diagonal();

    /// Add the block's product with src to dst.
    void
    add_product(const Block &block, const double *src, double *dst) const;

    const PointCloud<dim> &points;
    const Fill<dim>       &fill;
    const Occupancy<dim>  &occupancy;
    const Field           *linear_masses; // of linear cells, or null
    std::vector<Block>     blocks;
    /// Dense, [a * nodes.size() + b]; those of equal faces are kept once.
    std::vector<std::vector<double>> matrices;
    std::vector<EdgeCell>            edge_cells;
    Field inverse_diagonal; // zero where there is no mass
  };
} // namespace seiche

#endif
