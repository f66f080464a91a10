// SPDX-License-Identifier: LGPL-2.1-or-later
// The adaptive mesh: levels where the criteria ask for them, nothing changes
// in a second pass, hanging nodes keep linear functions, ghost faces see no
// jump in them, also across level jumps. Same output on any number of ranks.
#include <seiche/grid/ghost_face_matrix.h>

#include "global_reductions.h"
#include "problem_from_text.h"

namespace
{
  using namespace seiche;
  using dealii::Point;

  /// Fluid in a corner of a box of cells 0.2; three levels, an obstacle, and a
  /// box that forces a level jump through the surface.
  template <int dim>
  std::string
  scene_text()
  {
    const std::string zero   = dim == 3 ? ", 0" : "";
    const auto        corner = [](const std::string &v) {
      return v + ", " + v + (dim == 3 ? ", " + v : "");
    };
    return "subsection Grid\n set Lower corner = " + corner("0") +
           "\n set Upper corner = " + corner("1.6") +
           "\n set Cell size = 0.2\nend\n"
           "subsection Obstacle block\n set Lower corner = 0.8, 0" +
           zero + "\n set Upper corner = 1.0, 0.2" + (dim == 3 ? ", 0.2" : "") +
           "\nend\n"
           "subsection Fluid body a\n set Lower corner = " +
           corner("0") + "\n set Upper corner = " + corner("0.8") +
           "\nend\n"
           "subsection Points\n set Jitter = 0.3\n"
           "set Per cell and direction = 2\nend\n"
           "subsection Refinement surface\n set Criterion = free surface\n"
           "set Level = 1\nend\n"
           "subsection Refinement fluid\n set Criterion = fluid\n"
           "set Level = 0\n set Layers = 1\nend\n"
           "subsection Refinement wall\n set Criterion = walls\n"
           "set Names = block\n set Distance = 0.05\n set Level = 2\nend\n"
           "subsection Refinement probe\n set Criterion = box\n"
           "set Lower corner = " +
           corner("0.7") + "\n set Upper corner = " + corner("0.85") +
           "\n set Level = 2\nend\n";
  }

  template <int dim>
  double
  linear(const Point<dim> &x)
  {
    return 1. + 2. * x[0] - 3. * x[1] + (dim == 3 ? 0.7 * x[dim - 1] : 0.);
  }

  /// Values of the linear function at the cell's own nodes from those at the
  /// nodes that are unknowns.
  template <int dim>
  double
  error_of_linear(const Occupancy<dim>                  &occupancy,
                  const typename Occupancy<dim>::Vector &values)
  {
    double error = 0.;
    for (unsigned int cell = 0; cell < occupancy.locator.cells.n_owned();
         ++cell)
      {
        if (!occupancy.cells.is_active(cell))
          continue;
        double at[Basis<dim, 1>::n_nodes];
        for (unsigned int a = 0; a < Basis<dim, 1>::n_nodes; ++a)
          at[a] = values.local_element(occupancy.nodes.of_cell(cell)[a]);
        occupancy.expand(cell, at);
        for (unsigned int a = 0; a < Basis<dim, 1>::n_nodes; ++a)
          {
            Point<dim> x = occupancy.locator.cells.geometry(cell).lower;
            for (unsigned int d = 0; d < dim; ++d)
              x[d] += Basis<dim, 1>::line_index(a, d) *
                      occupancy.locator.cells.geometry(cell).edges[d];
            error = std::max(error, std::abs(at[a] - linear<dim>(x)));
          }
      }
    return global_max(error);
  }

  /// Number of masters that are not in the corner of the hanging node whose
  /// slot they take, and of all masters in such slots.
  template <int dim>
  std::pair<unsigned int, unsigned int>
  misplaced_masters(const Occupancy<dim> &occupancy)
  {
    std::pair<unsigned int, unsigned int> result(0, 0);
    for (const unsigned int cell : occupancy.cells.occupied())
      for (unsigned int a = 0; a < Basis<dim, 1>::n_nodes; ++a)
        if (occupancy.mesh_nodes.hanging.hangs(cell, a))
          {
            double column[Basis<dim, 1>::n_nodes] = {};
            column[a]                             = 1.;
            occupancy.expand(cell, column);
            if (std::all_of(std::begin(column),
                            std::end(column),
                            [](const double v) { return v == 0.; }))
              continue; // no master: the middle of a face
            ++result.second;
            const Point<dim> x =
              occupancy.nodes.position(occupancy.nodes.of_cell(cell)[a]);
            const Point<dim> low = occupancy.locator.cells.geometry(cell).lower;
            const dealii::Tensor<1, dim> h =
              occupancy.locator.cells.geometry(cell).edges;
            for (unsigned int d = 0; d < dim; ++d)
              if ((x[d] > low[d] + 0.5 * h[d]) !=
                  (Basis<dim, 1>::line_index(a, d) == 1))
                {
                  ++result.first;
                  break;
                }
          }
    return {global_sum(result.first), global_sum(result.second)};
  }

  /// Whether cells with fluid are as small as the criteria of scene_text() ask:
  /// in the box, beside the obstacle, and beside empty cells; and whether none
  /// has a neighbour of less than half its size.
  template <int dim>
  void
  judge_sizes(const PointCloud<dim> &points)
  {
    const CellLocator<dim> &locator = points.locator;
    constexpr double        quarter = 0.2 / 4. + 1e-9, half = 0.2 / 2. + 1e-9;
    unsigned int n_in_box = 0, n_at_wall = 0, n_at_surface = 0, n_jumps = 0;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      {
        const double     size   = locator.cells.geometry(cell).edges[0];
        const Point<dim> low    = locator.cells.geometry(cell).lower;
        const Point<dim> high   = locator.cells.geometry(cell).upper;
        bool             in_box = true, at_wall = false, at_surface = false;
        for (unsigned int d = 0; d < dim; ++d)
          in_box &= low[d] < 0.85 - 1e-9 && high[d] > 0.7 + 1e-9;
        for (unsigned int face = 0; face < 2 * dim; ++face)
          {
            at_wall |=
              locator.cells.wall_at(cell, face) == &locator.grid.wall(2 * dim);
            const unsigned int other = locator.cells.neighbor(cell, face);
            if (other == locator.invalid)
              continue;
            const double ratio = locator.cells.geometry(other).edges[0] / size;
            n_jumps += ratio < 0.4 || ratio > 2.1;
            at_surface |=
              other < locator.cells.n_owned() && points.n_points_in(other) == 0;
          }
        if (points.n_points_in(cell) == 0)
          continue;
        n_in_box += in_box && size > quarter;
        n_at_wall += at_wall && size > quarter;
        n_at_surface += at_surface && size > half;
      }
    print("small enough in the box: ",
          verdict(global_sum(n_in_box) == 0),
          ", at the obstacle: ",
          verdict(global_sum(n_at_wall) == 0),
          ", at the surface: ",
          verdict(global_sum(n_at_surface) == 0),
          ", neighbours at most of twice the size: ",
          verdict(global_sum(n_jumps) == 0));
  }

  template <int dim>
  void
  print_levels(const char *title, const CellLocator<dim> &locator)
  {
    std::vector<unsigned int> count(locator.grid.finest_level() + 1, 0);
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      ++count[locator.cells.level(cell)];
    std::string text;
    for (unsigned int &n : count)
      text += " " + std::to_string(global_sum(n));
    print(title, text);
  }

  template <int dim>
  void
  test()
  {
    print(dim, "D");
    ProblemFromText<dim>    problem(scene_text<dim>());
    const CellLocator<dim> &locator   = problem.locator;
    PointCloud<dim>        &points    = problem.points;
    Occupancy<dim>         &occupancy = problem.occupancy;
    const Fill<dim>        &fill      = problem.fill;
    print("points ", problem.seeding.n_points);
    print_levels("cells by level:", locator);
    judge_sizes(points);
    print("points ", points.n_global());
    const bool changes =
      problem.mesh_adaptation.update(problem.scene.grid.refinement.adapt_every);
    if (dealii::Utilities::MPI::n_mpi_processes(communicator) == 1)
      print("a second pass changes the mesh: ", changes);
    print_levels("cells by level:", locator);

    occupancy.reinit();
    problem.find_cells();
    print("nodes ", occupancy.nodes.n_global());
    typename Occupancy<dim>::Vector values(occupancy.nodes.partitioner());
    double                          volume = 0., filled = 0.;
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      {
        values.local_element(i) = linear<dim>(occupancy.nodes.position(i));
        filled +=
          fill.nodal_fill().local_element(i) * occupancy.nodes.volume(i);
      }
    values.update_ghost_values();
    for (const unsigned int cell : occupancy.cells.occupied())
      volume += fill.cell_fill(cell) * locator.cells.geometry(cell).measure;
    print("linear function kept: ",
          error_of_linear(occupancy, values) < 1e-13 ? "yes" : "no",
          ", fill of nodes sums up to that of cells: ",
          std::abs(global_sum(filled) - global_sum(volume)) <
              1e-9 * global_sum(volume) ?
            "yes" :
            "no");

    const auto [misplaced, masters] = misplaced_masters(occupancy);
    print("masters in slots of hanging nodes ",
          masters,
          ", not in their corner ",
          misplaced);

    // ghost faces: no jump in the linear function, rows sum up to zero, and
    // half the squared kink of |x_0 - place| is integrated exactly
    GhostFaceMatrix<dim, 1> matrix;
    double                  worst = 0., rows = 0.;
    unsigned int            hanging = 0;
    for (const GhostFace &face : fill.ghost_faces())
      {
        matrix.evaluate(face, occupancy);
        hanging +=
          locator.cells.level(face.lower) != locator.cells.level(face.upper);
        for (unsigned int a = 0; a < matrix.n_nodes; ++a)
          {
            double jump = 0., sum = 0.;
            for (unsigned int b = 0; b < matrix.n_nodes; ++b)
              {
                jump += matrix.B[a][b] * values.local_element(matrix.nodes[b]);
                sum += matrix.B[a][b];
              }
            worst = std::max(worst, std::abs(jump));
            rows  = std::max(rows, std::abs(sum));
          }
      }
    print("ghost faces ",
          global_sum(fill.ghost_faces().size()),
          ", across a level jump ",
          global_sum(hanging),
          ", jump of the linear function: ",
          global_max(worst) < 1e-11 ? "none" : "yes",
          ", row sums: ",
          global_max(rows) < 1e-11 ? "zero" : "not zero");

    // the fluid moves: the mesh follows, and leaves what is empty
    for (unsigned int step = 0; step < 8; ++step)
      {
        for (std::size_t p = 0; p < points.size(); ++p)
          points.data(PointColumn::position, 1)[p] += 0.05;
        points.locate();
        problem.adapt_mesh(step + 1);
        occupancy.update(points);
      }
    print_levels("moved up by 0.4, cells by level:", locator);
    judge_sizes(points);
    print("points ", points.n_global(), ", nodes ", occupancy.nodes.n_global());
  }

  /// Deep fluid that may coarsen over several levels: families of cells must be
  /// whole on a rank before they can, so the levels depend on no partition.
  template <int dim>
  void
  test_coarsening()
  {
    const std::string zero = dim == 3 ? ", 0" : "",
                      one  = dim == 3 ? ", 1.6" : "";
    const SceneFromText<dim> scene(
      "subsection Grid\n set Lower corner = 0, 0" + zero +
      "\n set Upper corner = 1.6, 1.6" + one + "\n set Break points " +
      (dim == 3 ? "z" : "y") +
      " = 0.4\n set Cell size = 0.1\nend\n"
      "subsection Fluid body a\n set Lower corner = 0, 0" +
      zero + "\n set Upper corner = 1.6, " + (dim == 3 ? "1.6, 1.5" : "1.5") +
      "\nend\nsubsection Points\n set Per cell and direction = 1\nend\n"
      "subsection Refinement surface\n set Criterion = free surface\n"
      "set Level = 1\nend\n");
    BackgroundGrid<dim> grid(scene.grid_parameters, communicator);
    CellLocator<dim>    locator(grid);
    PointCloud<dim>     points(locator, {}, communicator);
    seed_bodies(scene.seeding,
                scene.bodies,
                scene.input,
                material_of_density(1000.),
                points);
    MeshAdaptation<dim> adaptation(grid,
                                   locator,
                                   points,
                                   /*gauss_in_full_cells=*/true);
    print_levels("deep fluid, cells by forest level:", locator);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
  test_coarsening<2>();
  test_coarsening<3>();
}
