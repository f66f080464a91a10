// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_ghost_face_matrix_h
#define seiche_grid_ghost_face_matrix_h

#include <seiche/grid/fill.h>

namespace seiche
{
  /**
   * @brief B = int_F [dn N_a][dn N_b] [m^(dim-3)] of a ghost face: jumps of
   * normal derivatives between its two cells (Burman 2010; doc/theory.md
   * (6.1)).
   *
   * For FE_Q(2) jumps of the second normal derivative count too, times h^2/4.
   * Row sums are zero: momentum is conserved.
   */
  template <int dim, int degree>
  struct GhostFaceMatrix
  {
    using Shape                             = Basis<dim, degree>;
    static constexpr unsigned int max_nodes = 2 * Shape::n_nodes;

    /// Nodes of the two cells. For FE_Q(1) without hanging nodes these are 3
    /// in the direction of the normal, else the list of one cell and then of
    /// the other, and a node may occur in it twice.
    unsigned int n_nodes = 0;
    unsigned int nodes[max_nodes]; ///< local node indices
    double       B[max_nodes][max_nodes];
    double       h; ///< mean edge length along the normal [m]

    /// Local.
    void
    evaluate(const GhostFace &face, const Occupancy<dim> &occupancy);

    /// All but B, which is that of another face between equal cells. Local.
    void
    find_nodes(const GhostFace &face, const Occupancy<dim> &occupancy);

    /// B row by row [n_nodes * n_nodes].
    std::vector<double>
    dense() const
    {
      std::vector<double> result;
      for (unsigned int a = 0; a < n_nodes; ++a)
        result.insert(result.end(), B[a], B[a] + n_nodes);
      return result;
    }

  private:
    /// FE_Q(1), no hanging nodes: nodes lie on lines of three, B is in closed
    /// form.
    static bool
    is_conforming(const GhostFace &face, const Occupancy<dim> &occupancy);
    void
    find_lines(const GhostFace &face, const Occupancy<dim> &occupancy);
    void
    evaluate_conforming(const GhostFace &face, const Occupancy<dim> &occupancy);
    /// Everything else: by quadrature.
    void
    integrate(const GhostFace &face, const Occupancy<dim> &occupancy);

    /// Derivatives of the cell's shape functions along the normal, of order
    /// 1 and 2, at @p x with the sign of the side; masters in place of hanging
    /// nodes.
    static void
    normal_derivatives(const Occupancy<dim>     &occupancy,
                       const unsigned int        cell,
                       const unsigned int        direction,
                       const dealii::Point<dim> &x,
                       const double              sign,
                       double                   *first,
                       double                   *second);
  };
} // namespace seiche

#endif
