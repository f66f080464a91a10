// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_ghost_penalty_h
#define seiche_solve_ghost_penalty_h

#include <seiche/algebra/block_matrix.h>
#include <seiche/formulation/weak_form.h>
#include <seiche/grid/ghost_face_matrix.h>

#include <functional>

namespace seiche
{
  /**
   * @brief The ghost penalty of some terms (doc/theory.md (6.1), (6.2)) as a
   * matrix of three numbers a pair of nodes, the sums of GhostCoefficients
   * times B over the faces.
   *
   * All components of a vector share them, and they hold for all residuals and
   * tangents of a step: faces are looked at once, what follows are products
   * with a fraction of the pairs that faces have. Rows far from the surface do
   * not occur.
   */
  template <int dim>
  class GhostPenalty
  {
  public:
    using Vector      = typename BlockMatrix<dim>::Vector;
    using BlockVector = typename BlockMatrix<dim>::BlockVector;

    /// Of a face with the mean edge length h along its normal [m] and the
    /// degree that couples across it.
    using Coefficients =
      std::function<GhostCoefficients(const GhostFace   &face,
                                      const double       h,
                                      const unsigned int degree)>;

    explicit GhostPenalty(const NodePattern<dim> &pattern);

    /// Without faces.
    void
    clear();

    /// Over @p faces, which the pattern covers. Local.
    void
    assemble(const std::vector<GhostFace> &faces,
             const Coefficients           &coefficients);

    /// Add the residual of the displacement [m], with the offsets of
    /// acceleration and velocity (TimeScheme), and of the pressure [Pa] if
    /// there is one. Needs ghost values; rows of other ranks' nodes get their
    /// part, too. Local.
    void
    add_residual(const StepCoefficients &step,
                 const Vector           &inertia_offset,
                 const Vector           &rate_offset,
                 const BlockVector      &solution,
                 BlockVector            &residual) const;

    /// Add the derivative of add_residual(). Local.
    void
    add_tangent(const StepCoefficients &step, BlockMatrix<dim> &matrix) const;

  private:
    struct Pair
    {
      unsigned int      entry; ///< of the pattern
      unsigned int      node;  ///< local, of the column
      GhostCoefficients sum;
    };

    /// Rows at the nodes of the faces, with all entries of the pattern, none of
    /// them in use.
    void
    start_rows(const std::vector<GhostFace> &faces);

    template <int degree>
    void
    add_face(const GhostFaceMatrix<dim, degree> &face,
             const GhostCoefficients            &coefficients);

    /// Keep the entries in use.
    void
    compress();

    const NodePattern<dim>   &pattern;
    std::vector<unsigned int> rows;       ///< local nodes
    std::vector<unsigned int> first_pair; ///< [row, and the end]
    std::vector<Pair>         pairs;
    std::vector<unsigned int> row_of_node; ///< [local node], while assembling
  };
} // namespace seiche

#endif
