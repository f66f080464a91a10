// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_block_preconditioner_h
#define seiche_solve_block_preconditioner_h

#include <seiche/algebra/block_ilu.h>
#include <seiche/solve/assembler.h>
#include <seiche/solve/schur_complement.h>

#include <deal.II/lac/trilinos_precondition.h>

#include <Epetra_CrsMatrix.h>

#include <memory>

namespace seiche
{
  /**
   * @brief Block upper-triangular preconditioner of [A G; C D].
   *
   * z_p = S^-1 r_p, z_u = P_A (r_u - G z_p); S: SchurComplement. P_A: where A
   * is close to a mass matrix, BlockILU; Trilinos ML with the components'
   * constants where viscosity, tau2 or the bulk modulus dominate, or where all
   * factors are unstable (doc/theory.md (10.4), (10.5)).
   */
  template <int dim>
  class BlockPreconditioner
  {
  public:
    using Vector      = dealii::LinearAlgebra::distributed::Vector<double>;
    using BlockVector = dealii::LinearAlgebra::distributed::BlockVector<double>;

    /// @p multigrid: of the Schur complement.
    explicit BlockPreconditioner(const MultigridMethod &multigrid);

    /// Set up for a newly assembled matrix. Hierarchies and factors are kept
    /// until reset(): their values only steer convergence, and the
    /// matrices of a step differ by a factor above all. (Keeping them longer
    /// costs more than it saves: a cell that has become occupied since is
    /// unknown to them.) Collective.
    void
    initialize(const BlockMatrix<dim> &matrix,
               const Assembler<dim>   &assembler,
               const Vector           &mass);

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

    const BlockMatrix<dim> *matrix = nullptr;
    bool                    kept   = false;

    void
    apply_to_velocity(Vector &z, const Vector &r) const;

    BlockILU<dim> ilu; ///< P_A where there is no velocity_amg
    std::unique_ptr<Epetra_CrsMatrix>                          velocity_matrix;
    std::unique_ptr<dealii::TrilinosWrappers::PreconditionAMG> velocity_amg;

    bool         mass_dominated      = false; ///< so that ILU was tried
    unsigned int velocity_generation = 0;     ///< pattern of the factors
    double       velocity_inertia    = 0.;    ///< C_a that they belong to
    double       velocity_stiffness  = 0.;    ///< over inertia, likewise [-]
    double       velocity_factor     = 1.;

    SchurComplement<dim> schur;

    mutable Vector scratch_u, scratch_p;
  };
} // namespace seiche

#endif
