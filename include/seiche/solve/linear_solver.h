// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_solve_linear_solver_h
#define seiche_solve_linear_solver_h

#include <seiche/algebra/block_matrix.h>
#include <seiche/algebra/flexible_gmres.h>
#include <seiche/solve/assembler.h>
#include <seiche/solve/block_preconditioner.h>

#include <functional>
#include <limits>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of the linear solver (subsection "Solver").
  struct LinearSolverParameters
  {
    std::string  solver               = "automatic";
    std::string  multigrid            = "automatic";
    double       tolerance            = 1e-2;
    double       projection_tolerance = 1e-3;
    unsigned int maximum_iterations   = 200;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// InputError for a multigrid that might not be used.
    void
    check(const InputFile &input, const bool has_pressure) const;
  };

  /// What became of a solve.
  struct LinearResult
  {
    bool         converged   = false;
    bool         is_singular = false; ///< could not be factorised
    unsigned int iterations  = 0;     ///< Krylov iterations, 0 for direct
    double       reduction   = std::numeric_limits<double>::infinity();
    ///< residual over its first value, if failed

    /// Not as good as asked, but a gain: another iteration around it goes on.
    bool
    is_usable(const double largest_reduction) const
    {
      return converged || reduction <= largest_reduction;
    }

    /// What a user is told of a solve that is of no use.
    std::string
    problem() const;
  };

  /**
   * @brief Solves the linear systems of a step.
   *
   * Small systems (a function of the global number of unknowns only) go to a
   * sparse direct solver, the others to flexible GMRES with the
   * block-triangular preconditioner. Rows of the pressure are scaled by
   * rho C_a h, so that volume errors count as forces in the norm.
   */
  template <int dim>
  class LinearSolver
  {
  public:
    using BlockVector = typename BlockMatrix<dim>::BlockVector;

    /// What a solve may leave of the residual: the matrix has single precision.
    /// Who needs less goes on with the residual itself.
    static constexpr double finest_reduction = 1e-6;

    LinearSolver(const LinearSolverParameters &parameters, TimerTree &timer);

    /// Use @p matrix, assembled with @p assembler's coefficients, for the
    /// next solves. @p mass: lumped nodal mass [kg]. Collective.
    void
    initialize(const BlockMatrix<dim>                &matrix,
               const Assembler<dim>                  &assembler,
               const typename GridState<dim>::Vector &mass);

    /// A new step: nothing that was set up before is used again.
    void
    begin_step()
    {
      preconditioner.reset();
    }

    /// Reduce the scaled residual by @p tolerance, at most by finest_reduction,
    /// from zero. A solve that
    /// fails with a preconditioner of an earlier matrix is repeated with a new
    /// one, then, if the solver is "automatic" and the system not large,
    /// directly. The mean of the pressure is zero in closed chambers, where
    /// only its gradient counts. Collective.
    LinearResult
    solve(BlockVector       &solution,
          const BlockVector &right_hand_side,
          const double       tolerance);

    /// sqrt(sum of squares) of a residual with the pressure's row scaling.
    double
    norm(const BlockVector &residual) const;

  private:
    LinearResult
    solve_iteratively(BlockVector       &solution,
                      const BlockVector &right_hand_side,
                      const double       tolerance);

    const LinearSolverParameters parameters;
    TimerTree                   &timer;
    const BlockMatrix<dim>      *matrix = nullptr;
    std::function<void()>        set_up; ///< of the preconditioner
    double                       row_scale = 1.;
    bool                         direct    = false;
    bool                         rescue    = false;   ///< direct after failure
    const ClosedChambers<dim>   *closed    = nullptr; ///< null: none
    const typename GridState<dim>::Vector *mass = nullptr;
    BlockPreconditioner<dim>               preconditioner;
    FlexibleGMRES                          gmres;
    BlockVector                            scaled;
  };
} // namespace seiche

#endif
