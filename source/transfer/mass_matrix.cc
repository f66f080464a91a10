// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/ghost_face_matrix.h>
#include <seiche/mesh/assembled_faces.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/mass_matrix.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// As gamma_a of the ghost penalty on accelerations, with which it shares
    /// the scale rho h^3, near the surface. Elsewhere less: clusters and gaps
    /// of the points leave combinations of a cell's nodes free in full cells
    /// too.
    constexpr double ghost_factor = 0.1, inner_factor = 0.01;

    constexpr double       tolerance      = 1e-12; // of the right-hand side
    constexpr double       acceptable     = 1e-5;  // where round-off stops it
    constexpr unsigned int max_iterations = 500;
  } // namespace

  template <int dim>
  MassMatrix<dim>::MassMatrix(const PointCloud<dim>    &cloud,
                              const Fill<dim>          &grid_fill,
                              const CellMaterials<dim> &materials,
                              const bool                ghost_penalty,
                              const Vector             *masses_of_linear_cells)
    : points(cloud)
    , fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , linear_masses(masses_of_linear_cells)
  {
    with_degree(occupancy.fe.degree, [&](const auto degree) {
      this->template collect_cells<degree>();
      if (ghost_penalty)
        this->template collect_faces<degree>(materials);
    });

    inverse_diagonal.reinit(occupancy.nodes.vector_partitioner());
    for (const Block &block : blocks)
      for (unsigned int a = 0; a < block.nodes.size(); ++a)
        for (unsigned int c = 0; c < dim; ++c)
          inverse_diagonal.local_element(dim * block.nodes[a] + c) +=
            block.values[a * block.nodes.size() + a];
    inverse_diagonal.compress(VectorOperation::add);
    for (unsigned int i = 0; i < inverse_diagonal.locally_owned_size(); ++i)
      {
        double &value = inverse_diagonal.local_element(i);
        if (linear_masses != nullptr)
          value += linear_masses->local_element(i / dim);
        value = value > 0. ? 1. / value : 0.;
      }
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::collect_cells()
  {
    PointBatch<dim, degree, double> point;
    constexpr unsigned int          n_nodes = point.n_nodes;
    const double                   *mass    = points.data(PointColumn::mass);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (is_lumped(cell))
          continue;
        const auto &geometry = points.locator.cells.geometry(cell);
        double      matrix[n_nodes][n_nodes] = {};
        for (const std::size_t p : points.points_in(cell))
          {
            point.reinit_values(geometry.to_unit(points.position(p)));
            for (unsigned int a = 0; a < n_nodes; ++a)
              for (unsigned int b = 0; b < n_nodes; ++b)
                matrix[a][b] += mass[p] * point.N[a] * point.N[b];
          }
        occupancy.template unknowns<degree>(cell).condense_matrix(matrix);
        const unsigned int *nodes = occupancy.nodes.of_cell(cell);
        blocks.push_back({{nodes, nodes + n_nodes},
                          {&matrix[0][0], &matrix[0][0] + n_nodes * n_nodes}});
      }
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::collect_faces(const CellMaterials<dim> &materials)
  {
    GhostFaceMatrix<dim, degree> face_matrix;
    for_each_assembled_face(
      occupancy.locator,
      occupancy.cells.occupied(),
      [&](const unsigned int cell) {
        return occupancy.cells.is_occupied(cell);
      },
      [&](const unsigned int lower,
          const unsigned int upper,
          const unsigned int direction) {
        if (is_lumped(lower) && is_lumped(upper))
          return;
        face_matrix.evaluate({lower, upper, direction, /*fragment=*/false},
                             occupancy);
        const unsigned int n = face_matrix.n_nodes;
        const double       factor =
          (fill.is_cut(lower) || fill.is_cut(upper) ? ghost_factor :
                                                      inner_factor) *
          materials.mean(lower, upper).mass(std::pow(face_matrix.h, 3));
        Block block;
        block.nodes.assign(face_matrix.nodes, face_matrix.nodes + n);
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int b = 0; b < n; ++b)
            block.values.push_back(factor * face_matrix.B[a][b]);
        blocks.push_back(std::move(block));
      });
  }

  template <int dim>
  void
  MassMatrix<dim>::right_hand_side(const PointColumn column, Vector &dst) const
  {
    dst.reinit(occupancy.nodes.vector_partitioner());
    with_degree(occupancy.fe.degree, [&](const auto degree) {
      this->template sum_points<degree>(column, dst);
    });
    dst.compress(VectorOperation::add);
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::sum_points(const PointColumn column, Vector &dst) const
  {
    PointBatch<dim, degree, double> point;
    const double                   *mass = points.data(PointColumn::mass);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (is_lumped(cell))
          continue;
        const auto &geometry = points.locator.cells.geometry(cell);
        double      sum[dim][point.n_nodes] = {};
        for (const std::size_t p : points.points_in(cell))
          {
            point.reinit_values(geometry.to_unit(points.position(p)));
            for (unsigned int c = 0; c < dim; ++c)
              {
                const double momentum = mass[p] * points.data(column, c)[p];
                for (unsigned int a = 0; a < point.n_nodes; ++a)
                  sum[c][a] += point.N[a] * momentum;
              }
          }
        occupancy.template unknowns<degree>(cell).add_to_nodes(sum,
                                                               dst.begin());
      }
  }

  template <int dim>
  void
  MassMatrix<dim>::vmult(Vector &dst, const Vector &src) const
  {
    src.update_ghost_values();
    dst = 0.;
    dst.zero_out_ghost_values();
    for (const Block &block : blocks)
      {
        const unsigned int n = block.nodes.size();
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            {
              double sum = 0.;
              for (unsigned int b = 0; b < n; ++b)
                sum += block.values[a * n + b] *
                       src.local_element(dim * block.nodes[b] + c);
              dst.local_element(dim * block.nodes[a] + c) += sum;
            }
      }
    dst.compress(VectorOperation::add);
    src.zero_out_ghost_values();
    if (linear_masses != nullptr)
      for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
        dst.local_element(i) +=
          linear_masses->local_element(i / dim) * src.local_element(i);
    for (unsigned int i = 0; i < dst.locally_owned_size(); ++i)
      if (inverse_diagonal.local_element(i) == 0.)
        dst.local_element(i) = src.local_element(i);
  }

  template <int dim>
  void
  MassMatrix<dim>::solve(Vector &v, const Vector &b) const
  {
    v.zero_out_ghost_values();
    SolverControl          control(max_iterations,
                          std::max(tolerance * b.l2_norm(),
                                   std::numeric_limits<double>::min()));
    SolverCG<Vector>       solver(control);
    DiagonalMatrix<Vector> jacobi(inverse_diagonal);
    try
      {
        solver.solve(*this, v, b, jacobi);
      }
    catch (const SolverControl::NoConvergence &failure)
      {
        if (!(failure.last_residual <= acceptable * b.l2_norm()))
          throw NumericalError(fmt::format(
            "the consistent mass of the points did not converge in {} "
            "iterations (residual {:.1e}): too few points in a cell for its "
            "nodes. Set more Points/Per cell and direction, or Transfer/Mass = "
            "lumped.",
            failure.last_step,
            failure.last_residual / b.l2_norm()));
      }
  }

  template <int dim>
  void
  MassMatrix<dim>::expand(Vector            &v,
                          const Vector      &b,
                          const Vector      &lumped,
                          const unsigned int n_times) const
  {
    v.zero_out_ghost_values();
    Vector product(v);
    for (unsigned int k = 0; k < n_times; ++k)
      {
        vmult(product, v);
        for (unsigned int i = 0; i < v.locally_owned_size(); ++i)
          if (const double mass = lumped.local_element(i / dim); mass > 0.)
            v.local_element(i) +=
              (b.local_element(i) - product.local_element(i)) / mass;
      }
  }

  template class MassMatrix<2>;
  template class MassMatrix<3>;
} // namespace seiche
