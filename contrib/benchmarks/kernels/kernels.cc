// SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the kernels of a step, each on its own (google-benchmark).
//
// Two scenes in 2D and 3D, a column of water: "surface" takes the points of all
// cells as quadrature, as cells at the free surface do, "full" Gauss points.
// The positions are disordered; the state is that of the first step. Rates are
// points or cells a second (items_per_second).
#include <seiche/postprocess/grid_output.h>
#include <seiche/postprocess/point_output.h>
#include <seiche/solve/block_preconditioner.h>

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <map>

#include "workbench.h"

namespace
{
  enum class Cells
  {
    surface,
    full
  };

  template <int dim>
  std::string
  scene_file()
  {
    return std::string(SEICHE_SCENES) +
           (dim == 2 ? "/benchmarks/dam_break_2d/dam_break_2d.prm" :
                       "/benchmarks/column_collapse_3d/column_collapse_3d.prm");
  }

  template <int dim>
  std::map<Cells, std::unique_ptr<Workbench<dim>>> benches;

  /// Made once a program: setting it up takes longer than most kernels.
  template <int dim>
  Workbench<dim> &
  workbench(const Cells cells)
  {
    auto &bench = benches<dim>[cells];
    if (!bench)
      {
        std::vector<std::string> overrides = {
          "Points/Jitter = 0.3", "Solver/Linear solver = iterative"};
        if (cells == Cells::surface)
          overrides.push_back("Quadrature/Rule = material points");
        if (dim == 2)
          for (const char *entry : {"Grid/Cells x = 192, 320",
                                    "Grid/Cells y = 96, 384",
                                    "Time/Step = 0.001"})
            overrides.push_back(entry);
        bench = std::make_unique<Workbench<dim>>(scene_file<dim>(), overrides);
      }
    return *bench;
  }

  template <int dim>
  void
  count_points(benchmark::State &state, const Workbench<dim> &bench)
  {
    state.SetItemsProcessed(state.iterations() * bench.problem.points.size());
  }

  template <int dim>
  void
  count_cells(benchmark::State &state, const Workbench<dim> &bench)
  {
    state.SetItemsProcessed(state.iterations() *
                            bench.problem.occupancy.cells.n_global());
  }

  /// What an assembly takes its time for.
  template <int dim>
  void
  count(benchmark::State &state, const Workbench<dim> &bench, const Cells cells)
  {
    if (cells == Cells::surface)
      count_points(state, bench);
    else
      count_cells(state, bench);
  }

  template <int dim>
  void
  points_to_grid(benchmark::State &state)
  {
    auto &bench = workbench<dim>(Cells::full);
    for (auto _ : state)
      bench.problem.transfer.points_to_grid(bench.problem.points, bench.state);
    count_points(state, bench);
  }

  /// On a copy of the points: they must not leave their cells.
  template <int dim>
  void
  grid_to_points(benchmark::State &state)
  {
    auto                   &bench = workbench<dim>(Cells::full);
    seiche::PointCloud<dim> points(bench.problem.points);
    bench.state.velocity_np1 = bench.state.velocity_n;
    bench.state.velocity_np1.update_ghost_values();
    for (auto _ : state)
      bench.problem.transfer.grid_to_points(bench.state, points);
    count_points(state, bench);
  }

  /// With every fourth point in another cell than before.
  template <int dim>
  void
  locate_and_sort(benchmark::State &state)
  {
    auto                   &bench = workbench<dim>(Cells::full);
    seiche::PointCloud<dim> points(bench.problem.points);
    double way = 0.25 * bench.problem.occupancy.smallest_extent();
    for (auto _ : state)
      {
        state.PauseTiming();
        double *x = points.data(seiche::PointColumn::position);
        for (std::size_t p = 0; p < points.size(); ++p)
          x[p] += way;
        way = -way;
        state.ResumeTiming();
        points.locate();
      }
    count_points(state, bench);
  }

  template <int dim>
  void
  occupancy_and_fill(benchmark::State &state)
  {
    auto &bench = workbench<dim>(Cells::full);
    for (auto _ : state)
      bench.problem.find_cells();
    count_cells(state, bench);
  }

  template <int dim, Cells cells>
  void
  residual(benchmark::State &state)
  {
    auto &bench = workbench<dim>(cells);
    for (auto _ : state)
      bench.problem.assembler.residual(bench.state, bench.residual);
    count(state, bench, cells);
  }

  template <int dim, Cells cells>
  void
  tangent(benchmark::State &state)
  {
    auto &bench = workbench<dim>(cells);
    for (auto _ : state)
      bench.problem.assembler.tangent(bench.state, bench.problem.matrix);
    count(state, bench, cells);
  }

  template <int dim>
  void
  matrix_product(benchmark::State &state)
  {
    auto &bench = workbench<dim>(Cells::full);
    for (auto _ : state)
      bench.problem.matrix.vmult(bench.solution, bench.residual);
    const double entries = double(bench.problem.matrix.sparsity().n_entries()) *
                           (dim + 1) * (dim + 1);
    state.SetItemsProcessed(state.iterations() *
                            bench.problem.occupancy.nodes.n_own());
    state.SetBytesProcessed(state.iterations() * entries * sizeof(double));
  }

  /// ILU(0) of the velocity block, Schur complement and its hierarchy.
  template <int dim>
  void
  preconditioner_set_up(benchmark::State &state)
  {
    auto                            &bench = workbench<dim>(Cells::full);
    seiche::BlockPreconditioner<dim> preconditioner(
      seiche::multigrid_method(bench.planned.scene.linear_solver.multigrid));
    for (auto _ : state)
      {
        preconditioner.reset();
        preconditioner.initialize(bench.problem.matrix,
                                  bench.problem.assembler,
                                  bench.state.mass);
      }
    state.SetItemsProcessed(state.iterations() *
                            bench.problem.occupancy.nodes.n_own());
  }

  template <int dim>
  void
  preconditioner_cycle(benchmark::State &state)
  {
    auto                            &bench = workbench<dim>(Cells::full);
    seiche::BlockPreconditioner<dim> preconditioner(
      seiche::multigrid_method(bench.planned.scene.linear_solver.multigrid));
    preconditioner.initialize(bench.problem.matrix,
                              bench.problem.assembler,
                              bench.state.mass);
    for (auto _ : state)
      preconditioner.vmult(bench.solution, bench.residual);
    state.SetItemsProcessed(state.iterations() *
                            bench.problem.occupancy.nodes.n_own());
  }

  /// A frame of the points and one of the cells, written to the disk.
  template <int dim>
  void
  output(benchmark::State &state)
  {
    auto                       &bench = workbench<dim>(Cells::full);
    const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      fmt::format("seiche_kernels_{}", getpid());
    std::filesystem::create_directories(folder);
    const seiche::FrameSettings settings{folder.string(), 1., 1e300};
    seiche::PointOutput<dim>    point_output(settings, MPI_COMM_WORLD);
    seiche::GridOutput<dim>     grid_output(
      settings, std::make_shared<seiche::NodalPressure<dim>>(), MPI_COMM_WORLD);
    seiche::StatisticsTable statistics((folder / "statistics.csv").string(),
                                       /*writes=*/true);
    seiche::StepView<dim>   view = bench.view();
    for (auto _ : state)
      {
        point_output.execute(view, statistics);
        grid_output.execute(view, statistics);
        view.time += settings.interval;
      }
    std::filesystem::remove_all(folder);
    count_points(state, bench);
  }
} // namespace

#define SEICHE_KERNEL(...) \
  BENCHMARK_TEMPLATE(__VA_ARGS__)->Unit(benchmark::kMillisecond)

#define SEICHE_KERNELS(dim)                     \
  SEICHE_KERNEL(points_to_grid, dim);           \
  SEICHE_KERNEL(grid_to_points, dim);           \
  SEICHE_KERNEL(locate_and_sort, dim);          \
  SEICHE_KERNEL(occupancy_and_fill, dim);       \
  SEICHE_KERNEL(residual, dim, Cells::surface); \
  SEICHE_KERNEL(tangent, dim, Cells::surface);  \
  SEICHE_KERNEL(residual, dim, Cells::full);    \
  SEICHE_KERNEL(tangent, dim, Cells::full);     \
  SEICHE_KERNEL(matrix_product, dim);           \
  SEICHE_KERNEL(preconditioner_set_up, dim);    \
  SEICHE_KERNEL(preconditioner_cycle, dim);     \
  SEICHE_KERNEL(output, dim)

SEICHE_KERNELS(2);
SEICHE_KERNELS(3);

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 2;
  benchmark::RunSpecifiedBenchmarks();
  benches<2>.clear(); // before MPI ends
  benches<3>.clear();
  return 0;
}
