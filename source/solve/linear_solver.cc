// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/algebra/direct_solver.h>
#include <seiche/parameters/input_file.h>
#include <seiche/solve/linear_solver.h>
#include <seiche/utilities/injected_fault.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Systems with fewer unknowns (all ranks) are factorised. Measured, see
    /// doc/performance.md; a function of the global size only, so that all
    /// rank counts choose alike.
    constexpr types::global_dof_index direct_below = 250;

    /// Smaller systems that the iteration fails on are factorised: about a
    /// second each in 3D, and seldom.
    constexpr types::global_dof_index rescue_below = 5000;

    /// The system with scaled pressure rows, as GMRES wants it; their mean
    /// left out in closed chambers, as in the residual.
    template <int dim>
    struct ScaledOperator
    {
      const BlockMatrix<dim>                &matrix;
      const double                           row_scale;
      const ClosedChambers<dim>             *closed;
      const typename GridState<dim>::Vector &mass;

      void
      vmult(typename BlockMatrix<dim>::BlockVector       &dst,
            const typename BlockMatrix<dim>::BlockVector &src) const
      {
        matrix.vmult(dst, src);
        if (closed != nullptr)
          closed->balance_rows(dst.block(1), mass);
        if (matrix.has_pressure())
          dst.block(1) *= row_scale;
      }
    };
  } // namespace

  void
  LinearSolverParameters::add_parameters(ParameterHandler &prm)
  {
    std::string names, text = "Multigrid for the Schur complement of the "
                              "pressure. ";
    for (const MultigridMethod &method : multigrid_methods())
      {
        names += (names.empty() ? "" : "|") + std::string(method.name);
        text += std::string(method.name) + ": " + method.description + "; ";
      }
    text += "all but automatic need Linear solver = iterative and are then "
            "used in every system [-]";
    prm.enter_subsection("Solver");
    prm.add_parameter("Linear solver",
                      solver,
                      "direct: sparse factorisation, in 3D 100 times dearer "
                      "than iterative at 12000 unknowns; iterative: flexible "
                      "GMRES with AMG; automatic: by the number of unknowns",
                      Patterns::Selection("automatic|direct|iterative"));
    prm.add_parameter("Multigrid", multigrid, text, Patterns::Selection(names));
    prm.add_parameter(
      "Linear tolerance",
      tolerance,
      "Residual over its first value at which the first linear "
      "solve of a step ends; later ones end where Eisenstat and "
      "Walker (1996) advise, at most at this or at half of the "
      "reduction still needed, whichever is more [-]",
      Patterns::Double(1e-15, 0.3));
    prm.add_parameter("Projection tolerance",
                      projection_tolerance,
                      "Reduction of the residual asked of the projection of "
                      "the start velocity [-]",
                      Patterns::Double(1e-15, 0.9));
    prm.add_parameter("Linear maximum iterations",
                      maximum_iterations,
                      "Krylov iterations after which a solve has failed",
                      Patterns::Integer(1));
    prm.leave_subsection();
  }

  void
  LinearSolverParameters::check(const InputFile &input,
                                const bool       has_pressure) const
  {
    const bool is_automatic = multigrid_method(multigrid).factorises_small;
    if (has_pressure && solver != "direct")
      input.cites(std::string("saad1993 cahouet1988 ") +
                  multigrid_method(multigrid).papers);
    for (const char *entry :
         {"Solver/Linear tolerance", "Solver/Linear maximum iterations"})
      input.read_only_if(solver != "direct",
                         entry,
                         "Solver/Linear solver = iterative or automatic");
    input.read_only_if(has_pressure,
                       "Solver/Projection tolerance",
                       "Formulation/Name = displacement-pressure");
    input.require(is_automatic || has_pressure,
                  "Solver/Multigrid",
                  "the irreducible form has no pressure to solve for: set it "
                  "to automatic, or Formulation/Name = displacement-pressure");
    input.require(is_automatic || solver == "iterative",
                  "Solver/Multigrid",
                  "a named one needs Linear solver = iterative, as the others "
                  "factorise (automatic: small systems); or set it to "
                  "automatic");
  }

  std::string
  LinearResult::problem() const
  {
    if (is_singular)
      return "the matrix of the step is singular: nothing determines some of "
             "the velocities or pressures";
    return fmt::format("the linear solver stopped after {} iterations",
                       iterations);
  }

  template <int dim>
  LinearSolver<dim>::LinearSolver(const LinearSolverParameters &p, TimerTree &t)
    : parameters(p)
    , timer(t)
    , preconditioner(multigrid_method(parameters.multigrid))
  {}

  template <int dim>
  void
  LinearSolver<dim>::initialize(
    const BlockMatrix<dim>                &system_matrix,
    const Assembler<dim>                  &assembler,
    const typename GridState<dim>::Vector &node_mass)
  {
    matrix                          = &system_matrix;
    mass                            = &node_mass;
    const Occupancy<dim> &occupancy = matrix->occupancy;
    row_scale =
      assembler.materials.largest().inertia(assembler.coefficients().inertia) *
      occupancy.smallest_extent();
    preconditioner.pressure_row_scale = row_scale;

    const types::global_dof_index unknowns =
      occupancy.nodes.n_global() * matrix->n_fields();
    direct = parameters.solver == "direct" ||
             (parameters.solver == "automatic" && unknowns < direct_below);
    rescue = parameters.solver == "automatic" && unknowns < rescue_below;
    closed = assembler.closed_chambers();
    set_up = [this, &assembler]() {
      const TimerTree::Scope scope(timer, "preconditioner");
      preconditioner.initialize(*matrix, assembler, *mass);
    };
    if (!direct)
      set_up();
  }

  template <int dim>
  double
  LinearSolver<dim>::norm(const BlockVector &residual) const
  {
    double square = residual.block(0).norm_sqr();
    if (residual.n_blocks() == 2)
      square += row_scale * row_scale * residual.block(1).norm_sqr();
    return std::sqrt(square);
  }

  template <int dim>
  LinearResult
  LinearSolver<dim>::solve(BlockVector       &solution,
                           const BlockVector &right_hand_side,
                           const double       tolerance)
  {
    const TimerTree::Scope scope(timer, "linear solve");
    LinearResult           result;
    if (is_injected(Fault::stall))
      return result;
    if (is_injected(Fault::singular))
      {
        result.is_singular = true;
        return result;
      }
    const auto factorise = [&]() {
      result.converged =
        solve_directly<dim>(*matrix, closed, solution, right_hand_side);
      // nothing solves for what is not a number
      result.is_singular =
        !result.converged && std::isfinite(right_hand_side.l2_norm());
    };
    if (direct)
      factorise();
    else
      {
        result = solve_iteratively(solution, right_hand_side, tolerance);
        if (!result.converged && preconditioner.is_kept())
          {
            const unsigned int wasted = result.iterations;
            preconditioner.reset();
            set_up();
            result = solve_iteratively(solution, right_hand_side, tolerance);
            result.iterations += wasted;
          }
        if (!result.converged && rescue)
          factorise();
      }
    if (closed != nullptr)
      closed->level_pressure(solution.block(1));
    if (is_injected(Fault::update) && solution.block(0).locally_owned_size())
      solution.block(0).local_element(0) =
        std::numeric_limits<double>::quiet_NaN();
    return result;
  }

  template <int dim>
  LinearResult
  LinearSolver<dim>::solve_iteratively(BlockVector       &solution,
                                       const BlockVector &right_hand_side,
                                       const double       tolerance)
  {
    scaled = right_hand_side;
    if (matrix->has_pressure())
      scaled.block(1) *= row_scale;
    const double target =
      std::max(tolerance, finest_reduction) * scaled.l2_norm();
    solution = 0.;
    LinearResult result;
    result.reduction = 1.;
    if (!std::isfinite(target))
      return result;
    const ScaledOperator<dim> scaled_matrix{*matrix, row_scale, closed, *mass};
    result.converged =
      gmres.solve(scaled_matrix,
                  solution,
                  scaled,
                  preconditioner,
                  std::max(target, std::numeric_limits<double>::min()),
                  parameters.maximum_iterations);
    result.iterations = gmres.iterations;
    if (!result.converged)
      {
        // the solver's own estimate may be far off after this many iterations
        BlockVector rest(scaled);
        scaled_matrix.vmult(rest, solution);
        rest -= scaled;
        result.reduction = rest.l2_norm() / scaled.l2_norm();
      }
    return result;
  }

  template class LinearSolver<2>;
  template class LinearSolver<3>;
} // namespace seiche
