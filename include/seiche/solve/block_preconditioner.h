// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_block_preconditioner_h
#define seiche_solve_block_preconditioner_h

#include <seiche/solve/assembler.h>
#include <seiche/solve/block_matrix.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <Ifpack_Chebyshev.h>

#include <memory>

namespace seiche
{
  /**
   * @brief Block upper-triangular preconditioner of [A G; C D].
   *
   * z_p = S^-1 r_p, z_u = P_A (r_u - G z_p). S is the pressure Schur
   * complement D - C A^-1 G: with subscales it is Laplacian-like,
   * S = D/(rho C_a tau1), so that one scalar ML hierarchy serves; without
   * them it is formed with diag(A). P_A: Chebyshev sweeps where A is close to
   * a mass matrix, ML with the components' constants where viscosity, tau2 or
   * the bulk modulus dominate. Viscous fluids add 2 mu c_r/M_p to S^-1
   * (Cahouet and Chabard 1988). (doc/theory.md, "Linear systems")
   */
  template <int dim>
  class BlockPreconditioner
  {
  public:
    using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /// Set up for a newly assembled matrix. The ML hierarchy of the Schur
    /// complement is kept while the pattern lives and force_setup is not
    /// called: its values only steer convergence. Collective.
    void
    initialize(const BlockMatrix<dim>  &matrix,
               const Assembler<dim>    &assembler,
               const MaterialConstants &material,
               const Vector            &mass,
               const bool               closed);

    /// Drop the hierarchy: the next initialize() builds a new one.
    void
    force_setup();

    void
    vmult(BlockVector &z, const BlockVector &r) const;

    /// Factor of the pressure rows of the system (LinearSolver).
    double pressure_row_scale = 1.;

  private:
    void
    initialize_velocity(const double stiffness);
    void
    initialize_schur(const Assembler<dim>    &assembler,
                     const MaterialConstants &material);

    const BlockMatrix<dim> *matrix = nullptr;
    bool                    closed = false; ///< pressure up to a constant

    std::unique_ptr<Ifpack_Chebyshev>                       chebyshev;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> velocity_amg;

    std::unique_ptr<Epetra_CrsMatrix>                       schur;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> schur_amg;
    unsigned int schur_generation = 0;
    double       schur_factor     = 1.; ///< S^-1 = factor * hierarchy

    double         viscous_factor = 0.; ///< 2 mu c_r [Pa]
    Vector         volume;              ///< lumped pressure mass [m^dim]
    mutable Vector scratch_u, scratch_p;
  };
} // namespace seiche

#endif
