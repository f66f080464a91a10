// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_residual_projection_h
#define seiche_solve_residual_projection_h

#include <seiche/solve/assembler.h>

namespace seiche
{
  /**
   * @brief The projection of the residuals that orthogonal subscales subtract
   * (Codina 2000; doc/theory.md (4.5a)).
   *
   * Pi r and Pi g with M Pi f = sum over the quadrature points of V f N, M the
   * lumped or the consistent mass of the same points. Does nothing for the
   * other stabilizations.
   */
  template <int dim>
  class ResidualProjection
  {
  public:
    using BlockVector = typename GridState<dim>::BlockVector;

    ResidualProjection(Assembler<dim>        &assembler,
                       const Quadrature<dim> &quadrature,
                       const Occupancy<dim>  &occupancy);

    /// Project at the first guess of a step; the assembler subtracts the
    /// result until its next begin(). Collective.
    void
    begin(const GridState<dim> &state);

    /// Project again after Newton's iteration of this number, if the entry
    /// "Projection updates" wants it. False: nothing has changed. Collective.
    bool
    update(const GridState<dim> &state, const unsigned int iteration);

    /// dst = M src, consistent, for all fields; for the conjugate gradients.
    void
    vmult(BlockVector &dst, const BlockVector &src) const;

  private:
    void
    project(const GridState<dim> &state);

    /// sum of V w_a over the points: w_a = N_a of a lumped mass or N_a^2, the
    /// diagonal. Its inverse for each unknown, zero where there is no fluid.
    void
    make_diagonal();

    template <int degree>
    void
    add_diagonal(const unsigned int cell);

    template <int degree>
    void
    add_products(const unsigned int cell,
                 const BlockVector &src,
                 BlockVector       &dst) const;

    Assembler<dim>        &assembler;
    const Quadrature<dim> &quadrature;
    const Occupancy<dim>  &occupancy;
    const bool             active;    ///< orthogonal subscales
    const bool             lumped;    ///< mass of the projection
    const unsigned int     n_updates; ///< "Projection updates"
    BlockVector            projected, sums, inverse_diagonal;
  };
} // namespace seiche

#endif
