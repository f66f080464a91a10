// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_schur_complement_h
#define seiche_solve_schur_complement_h

#include <seiche/algebra/cholesky_factors.h>
#include <seiche/algebra/multigrid.h>
#include <seiche/solve/assembler.h>

namespace seiche
{
  /**
   * @brief S^-1 of [A G; C D], S = D - C A^-1 G, approximately.
   *
   * Where tau1 is the same in all cells of a size S is D/(rho C_a tau1),
   * Laplacian-like, so that one multigrid hierarchy serves all solves of a
   * step; where subscales vary S is formed with the lumped inertia (D and C
   * A^-1 G nearly cancel where tau1 is large), without subscales with diag(A).
   * Where the method says so a small symmetric S is factorised on one rank.
   * Viscous fluids add 2 mu c_r/M_p to S^-1 (Cahouet and Chabard 1988;
   * doc/theory.md (10.5), (10.6)).
   */
  template <int dim>
  class SchurComplement
  {
  public:
    using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    explicit SchurComplement(const MultigridMethod &method);

    /// Set up for a newly assembled matrix; @p mass [kg] lumped, of nodes. True
    /// if the hierarchy or the factors of an earlier matrix serve. Collective.
    bool
    initialize(const BlockMatrix<dim> &matrix,
               const Assembler<dim>   &assembler,
               const Vector           &mass);

    /// The next initialize() keeps nothing.
    void
    reset()
    {
      generation = 0;
    }

    /// z = S^-1 r; in closed chambers the mean of both is left out.
    /// Collective.
    void
    vmult(Vector &z, Vector &r) const;

  private:
    /// D - C A^-1 G with C_a m in place of A, @p inertia C_a [1/s^2]; with
    /// diag(A) where that is zero. Collective.
    DistributedRows
    product(const double inertia, const Vector &mass) const;

    /// What D of own nodes gets on its diagonal: C_a = @p inertia times the
    /// row sums of -C diag(A)^-1 G. With subscales C is the flux through the
    /// free surface alone; without it D would leave constants free. Collective.
    std::vector<double>
    surface_term(const double inertia) const;

    /// scale D + surface.
    DistributedRows
    scaled_rows(const double scale, const std::vector<double> &surface) const;
    /// The same on one rank, lower triangle.
    LowerTriangle
    scaled_triangle(const double               scale,
                    const std::vector<double> &surface) const;
    /// f(column, value) for the diagonal of an own node's row of either, then
    /// for the others from the entry @p first on.
    template <typename Function>
    void
    for_each_scaled_entry(const unsigned int node,
                          const unsigned int first,
                          const double       scale,
                          const double       surface,
                          const Function    &f) const;

    const MultigridMethod     &method;
    const BlockMatrix<dim>    *matrix     = nullptr;
    const ClosedChambers<dim> *closed     = nullptr; ///< null: none
    unsigned int               generation = 0;       ///< pattern, 0: none
    double                     factor     = 1.; ///< S^-1 = factor * hierarchy

    // one of these two
    std::unique_ptr<Multigrid> hierarchy;
    mutable CholeskyFactors    cholesky;

    std::vector<double> viscous; ///< 2 mu c_r M_p^-1 [Pa/m^dim], or empty
  };
} // namespace seiche

#endif
