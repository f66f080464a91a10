// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef contrib_benchmarks_kernels_workbench_h
#define contrib_benchmarks_kernels_workbench_h

#include <seiche/postprocess/postprocessor.h>
#include <seiche/simulation/step_solver.h>

#include <string>
#include <vector>

/**
 * @brief A scene in its first step, before Newton's iteration: what a kernel
 * needs to be called again and again.
 */
template <int dim>
struct Workbench
{
  using BlockVector = typename seiche::GridState<dim>::BlockVector;

  Workbench(const std::string              &filename,
            const std::vector<std::string> &overrides)
    : input(filename, overrides)
    , planned(input, MPI_COMM_WORLD)
    , report({/*directory=*/"", planned.scene.time.end_time}, MPI_COMM_WORLD)
    , problem(planned, timer)
    , step_solver(problem, report, timer)
  {
    problem.find_cells();
    problem.find_unknowns();
    problem.points_to_grid(state);
    state.dt = planned.scene.time.step;
    step_solver.begin(state);
    step_solver.find_start_velocity(state, /*projects=*/false);
    step_solver.predict(state);
    residual.reinit(state.solution);
    solution.reinit(state.solution);
    problem.assembler.residual(state, residual);
    problem.assembler.tangent(state, problem.matrix);
  }

  /// What postprocessors see of it.
  seiche::StepView<dim>
  view() const
  {
    seiche::StepView<dim> result(problem.points, problem.fill, state);
    result.bulk_modulus = planned.scene.fluid.volume_law.bulk_modulus;
    result.theta = result.pressure_theta = 0.5;
    return result;
  }

  const seiche::InputFile         input;
  const seiche::PlannedScene<dim> planned;
  seiche::TimerTree               timer;
  seiche::RunReport               report;
  seiche::Problem<dim>            problem;
  seiche::StepSolver<dim>         step_solver;
  seiche::GridState<dim>          state;
  BlockVector                     residual, solution;
};

#endif
