// SPDX-License-Identifier: LGPL-2.1-or-later
// The system matrix with hanging nodes, fixed components and shared rows: its
// product against that of the copy for Trilinos, the product with G alone, the
// same sums on any number of ranks; its ILU(0) is exact where nothing is left
// out.
#include <seiche/algebra/block_ilu.h>
#include <seiche/algebra/epetra_copy.h>
#include <seiche/grid/ghost_face_matrix.h>
#include <seiche/grid/mesh_adaptation.h>

#include <Epetra_Vector.h>

#include "scene_from_text.h"

namespace
{
  using namespace seiche;
  using dealii::Point;

  const MPI_Comm communicator = MPI_COMM_WORLD;

  const char *
  is_small(const double error, const double bound)
  {
    return dealii::Utilities::MPI::max(error, communicator) < bound ? "yes" :
                                                                      "no";
  }

  /// A field of the node alone, so that it is the same on any ranks.
  template <int dim>
  double
  field(const Point<dim> &x, const unsigned int component)
  {
    return std::sin(1. + component + 2. * x[0] - 3. * x[1] +
                    0.5 * x[dim - 1] * x[dim - 1]);
  }

  /// Cell matrices of a made-up coupling that decays with distance.
  template <int dim>
  void
  assemble(BlockMatrix<dim> &matrix)
  {
    const Occupancy<dim> &occupancy = matrix.occupancy;
    CellMatrix<dim, 1>    data;
    matrix.reinit();
    matrix.set_zero();
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const Point<dim> corner = occupancy.locator.cells.geometry(cell).lower;
        const auto       entry =
          [&](auto &block, const double shift, const double diagonal) {
            for (unsigned int a = 0; a < CellMatrix<dim, 1>::n_nodes; ++a)
              for (unsigned int b = 0; b < CellMatrix<dim, 1>::n_nodes; ++b)
                block[a][b] = std::cos(a + 2. * b + shift + corner[0]) +
                              (a == b ? diagonal : 0.);
            occupancy.template unknowns<1>(cell).condense_matrix(block);
          };
        for (unsigned int i = 0; i < dim; ++i)
          {
            for (unsigned int j = 0; j < dim; ++j)
              entry(data.uu[i][j], i + 0.3 * j, i == j ? 60. : 0.);
            entry(data.up[i], 5. + i, 0.);
            entry(data.pu[i], 9. + i, 0.);
          }
        entry(data.pp, 20., 40.);
        matrix.add_cell(cell, data);
      }
    GhostFaceMatrix<dim, 1> face_matrix;
    for (const GhostFace &face : matrix.sparsity().fill.ghost_faces())
      {
        face_matrix.evaluate(face, occupancy);
        for (unsigned int a = 0; a < face_matrix.n_nodes; ++a)
          for (unsigned int b = 0; b < face_matrix.n_nodes; ++b)
            {
              const unsigned int row    = face_matrix.nodes[a],
                                 column = face_matrix.nodes[b];
              matrix.add_pair(matrix.sparsity().entry(row, column),
                              row,
                              column,
                              0.7 * face_matrix.B[a][b],
                              0.4 * face_matrix.B[a][b]);
            }
      }
    matrix.compress();
  }

  template <int dim>
  typename BlockMatrix<dim>::BlockVector
  make_vector(const Occupancy<dim> &occupancy, const bool with_pressure)
  {
    typename BlockMatrix<dim>::BlockVector x(with_pressure ? 2 : 1);
    x.block(0).reinit(occupancy.nodes.vector_partitioner());
    if (with_pressure)
      x.block(1).reinit(occupancy.nodes.partitioner());
    x.collect_sizes();
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        const Point<dim> place = occupancy.nodes.position(node);
        for (unsigned int i = 0; i < dim; ++i)
          x.block(0).local_element(node * dim + i) = field(place, i);
        if (with_pressure)
          x.block(1).local_element(node) = field(place, dim);
      }
    return x;
  }

  template <int dim>
  std::string
  scene_text()
  {
    const std::string last = dim == 3 ? ", 0" : "";
    return "subsection Grid\n set Lower corner = 0, 0" + last +
           "\n set Upper corner = 1.6, 0.8" + (dim == 3 ? ", 0.8" : "") +
           "\n set Cell size = 0.2\nend\n"
           "subsection Fluid body a\n set Lower corner = 0, 0" +
           last + "\n set Upper corner = 0.9, 0.5" + (dim == 3 ? ", 0.8" : "") +
           "\nend\n"
           "subsection Points\n set Jitter = 0.3\n"
           "set Per cell and direction = 2\nend\n"
           "subsection Refinement fluid\n set Criterion = fluid\n"
           "set Level = 0\nend\n"
           "subsection Refinement right\n set Criterion = box\n"
           "set Lower corner = 0.6, 0" +
           last + "\n set Upper corner = 1.6, 0.8" + (dim == 3 ? ", 0.8" : "") +
           "\n set Level = 1\nend\n";
  }

  template <int dim>
  struct Setting
  {
    explicit Setting(const std::string &text)
      : scene(text)
      , grid(scene.grid_parameters, communicator)
      , locator(grid)
      , points(locator, {}, communicator)
    {
      seed_bodies(scene.seeding,
                  scene.bodies,
                  scene.input,
                  material_of_density(1000.),
                  points);
      adaptation = std::make_unique<MeshAdaptation<dim>>(
        grid, locator, points, /*gauss_in_full_cells=*/true);
      occupancy = std::make_unique<Occupancy<dim>>(locator, /*degree=*/1);
      occupancy->update(points);
      fill = std::make_unique<Fill<dim>>(*occupancy, QuadratureRule::cut_cells);
      fill->update(points);
    }

    const SceneFromText<dim>             scene;
    BackgroundGrid<dim>                  grid;
    CellLocator<dim>                     locator;
    PointCloud<dim>                      points;
    std::unique_ptr<MeshAdaptation<dim>> adaptation;
    std::unique_ptr<Occupancy<dim>>      occupancy;
    std::unique_ptr<Fill<dim>>           fill;
  };

  template <int dim>
  void
  test_product(const bool with_pressure)
  {
    const Setting<dim>    setting(scene_text<dim>());
    const Occupancy<dim> &occupancy = *setting.occupancy;
    BlockMatrix<dim>      matrix(*setting.fill, with_pressure);
    assemble(matrix);
    const auto x = make_vector(occupancy, with_pressure);
    auto       y = x;
    matrix.vmult(y, x);
    print(dim,
          with_pressure ? "D, mixed: nodes " : "D, irreducible: nodes ",
          occupancy.nodes.n_global(),
          ", norm of the product ",
          y.l2_norm() / x.l2_norm() / 100.);

    // against Trilinos, all fields in one matrix
    const unsigned int n    = matrix.n_fields();
    const auto         copy = epetra_copy(matrix, {0, n}, {0, n});
    Epetra_Vector      source(copy->DomainMap()), product(copy->RangeMap());
    const auto         at = [&](const auto        &vector,
                        const unsigned int node,
                        const unsigned int field) {
      return field < dim ? vector.block(0).local_element(node * dim + field) :
                                   vector.block(1).local_element(node);
    };
    for (int i = 0; i < source.MyLength(); ++i)
      source[i] = at(x, i / n, i % n);
    copy->Multiply(false, source, product);
    double error = 0.;
    for (int i = 0; i < product.MyLength(); ++i)
      error = std::max(error, std::abs(product[i] - at(y, i / n, i % n)));
    unsigned int empty = 0;
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      empty += matrix.is_empty(node);
    print("  as in Trilinos: ",
          is_small(error, 1e-10),
          ", rows without fluid ",
          dealii::Utilities::MPI::sum(empty, communicator));
    if (!with_pressure)
      return;

    auto only_pressure     = x;
    only_pressure.block(0) = 0.;
    matrix.vmult(y, only_pressure);
    auto force = x.block(0);
    matrix.gradient(force, x.block(1));
    // rows of fixed components are multiples of identity, and G has none
    error = 0.;
    for (unsigned int i = 0; i < force.locally_owned_size(); ++i)
      error = std::max(error,
                       std::abs(force.local_element(i) -
                                y.block(0).local_element(i)));
    print("  product with G alone: ", is_small(error, 1e-10));
  }

  /// Nodes of two cells, one upon the other and numbered so, leave nothing out:
  /// ILU(0) is LU, in single precision. On two ranks the second one's factors
  /// reach the nodes between the cells and no farther: x is zero beyond.
  template <int dim>
  void
  test_ilu()
  {
    const std::string  last  = dim == 3 ? "1, 2" : "2";
    const std::string  first = dim == 3 ? ", 0" : "";
    const Setting<dim> setting(
      "subsection Grid\n set Lower corner = 0, 0" + first +
      "\n set Upper corner = 1, " + last +
      "\n set Cell size = 1\nend\n"
      "subsection Walls\n set Left = open\n set Top = open\nend\n"
      "subsection Fluid body a\n set Lower corner = 0, 0" +
      first + "\n set Upper corner = 1, " + last +
      "\nend\nsubsection Points\n set Per cell and direction = 2\nend\n");
    BlockMatrix<dim> matrix(*setting.fill, /*pressure=*/false);
    assemble(matrix);
    BlockILU<dim> ilu;
    ilu.initialize(matrix, ForeignRows<dim>(matrix), 1.);
    auto x = make_vector(*setting.occupancy, false);
    for (unsigned int node = 0; node < setting.occupancy->nodes.n_own(); ++node)
      if (setting.occupancy->nodes.position(node)[dim - 1] < 0.5)
        for (unsigned int c = 0; c < dim; ++c)
          x.block(0).local_element(node * dim + c) = 0.;
    auto y = x, z = x;
    matrix.vmult(y, x);
    ilu.vmult(z.block(0), y.block(0));
    z -= x;
    print(dim,
          "D: ILU(0) of two cells is exact: ",
          is_small(z.linfty_norm(), 1e-5),
          ", growth below 2: ",
          is_small(ilu.growth(matrix), 2.));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_product<2>(false);
  test_product<2>(true);
  test_product<3>(false);
  test_product<3>(true);
  test_ilu<2>();
  test_ilu<3>();
}
