// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_block_preconditioner_h
#define seiche_solve_block_preconditioner_h

#include <seiche/solve/assembler.h>
#include <seiche/solve/block_ilu.h>
#include <seiche/solve/cholesky_factors.h>
#include <seiche/solve/sparse_factors.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <memory>

namespace seiche
{
  /**
   * @brief Block upper-triangular preconditioner of [A G; C D].
   *
   * z_p = S^-1 r_p, z_u = P_A (r_u - G z_p). S is the pressure Schur
   * complement D - C A^-1 G. Where tau1 is the same in all cells of a size it
   * is S = D/(rho C_a tau1), Laplacian-like, so that one scalar ML hierarchy
   * serves all solves of a step; where subscales vary it is formed with the
   * lumped inertia (D and C A^-1 G nearly cancel where tau1 is large), without
   * subscales with diag(A). A small S is factorised (on one rank by Cholesky's
   * method where it is symmetric, else by LU). P_A: where A is close to a
   * mass matrix, BlockILU; ML with the components' constants where viscosity,
   * tau2 or the bulk modulus dominate. Viscous fluids add 2 mu c_r/M_p to S^-1
   * (Cahouet and Chabard 1988). (doc/theory.md, "Linear systems")
   */
  template <int dim>
  class BlockPreconditioner
  {
  public:
    using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /// Set up for a newly assembled matrix. Hierarchies and factors are kept
    /// until reset(): their values only steer convergence, and the
    /// matrices of a step differ by a factor above all. (Keeping them longer
    /// costs more than it saves: a cell that has become occupied since is
    /// unknown to them.) Collective.
    void
    initialize(const BlockMatrix<dim>  &matrix,
               const Assembler<dim>    &assembler,
               const MaterialConstants &material,
               const Vector            &mass,
               const bool               closed);

    /// Drop everything (a new step, a failed solve): the next initialize()
    /// builds all of it.
    void
    reset();

    /// True if the last initialize() kept something of an earlier matrix.
    bool
    is_kept() const
    {
      return kept;
    }

    void
    vmult(BlockVector &z, const BlockVector &r) const;

    /// Factor of the pressure rows of the system (LinearSolver).
    double pressure_row_scale = 1.;

  private:
    void
    initialize_velocity(const double stiffness, const double inertia);
    void
    make_ilu();
    void
    make_velocity_amg();
    void
    initialize_schur(const Assembler<dim>    &assembler,
                     const MaterialConstants &material,
                     const Vector            &mass);

    /// What the Schur complement of own nodes gets on its diagonal: @p factor
    /// times the row sums of -C diag(A)^-1 G. With subscales C is the flux
    /// through the free surface alone; without it D would leave constants free.
    /// Collective.
    std::vector<double>
    surface_term(const double factor) const;

    /// (scale D + diagonal term), its diagonal times 1 + shift; one rank.
    LowerTriangle
    pressure_triangle(const double               scale,
                      const std::vector<double> &diagonal_term,
                      const double               shift) const;

    const BlockMatrix<dim> *matrix = nullptr;
    bool                    closed = false; ///< pressure up to a constant
    bool                    kept   = false;

    void
    apply_to_velocity(Vector &z, const Vector &r) const;
    void
    apply_to_pressure(Vector &z, const Vector &r) const;

    BlockILU<dim> ilu; ///< P_A where there is no velocity_amg
    std::unique_ptr<Epetra_CrsMatrix>                          velocity_matrix;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> velocity_amg;

    unsigned int velocity_generation = 0;  ///< pattern of the factors
    double       velocity_inertia    = 0.; ///< C_a that they belong to
    double       velocity_factor     = 1.;

    std::unique_ptr<Epetra_CrsMatrix> schur;
    // one of these three
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> schur_amg;
    mutable CholeskyFactors                                    schur_cholesky;
    mutable SparseFactors                                      schur_factors;

    unsigned int schur_generation = 0;
    double       schur_factor     = 1.; ///< S^-1 = factor * hierarchy

    double         viscous_factor = 0.; ///< 2 mu c_r [Pa]
    Vector         volume;              ///< lumped pressure mass [m^dim]
    mutable Vector scratch_u, scratch_p;
  };
} // namespace seiche

#endif
