// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/ghost_face_matrix.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/mass_matrix.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/lac/solver_cg.h>

#include <fmt/format.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double       tolerance      = 1e-12; // of the right-hand side
    constexpr double       acceptable     = 1e-5;  // where round-off stops it
    constexpr unsigned int max_iterations = 500;

    /// Diagonal preconditioner of fields with or without a block 1.
    template <typename Field>
    struct Jacobi
    {
      const Field &inverse_diagonal;

      void
      vmult(Field &dst, const Field &src) const
      {
        for (unsigned int k = 0; k < src.n_blocks(); ++k)
          {
            dst.block(k) = src.block(k);
            dst.block(k).scale(inverse_diagonal.block(k));
          }
      }
    };
  } // namespace

  template <int dim>
  typename MassMatrix<dim>::Field
  MassMatrix<dim>::field(const Vector &seen, const Vector &unseen)
  {
    Field result(unseen.size() > 0 ? 2 : 1);
    result.block(0) = seen;
    if (result.n_blocks() == 2)
      result.block(1) = unseen;
    result.collect_sizes();
    return result;
  }

  template <int dim>
  void
  MassMatrix<dim>::add_right_hand_side(const PointColumn column,
                                       Field            &dst) const
  {
    dst.zero_out_ghost_values();
    occupancy.for_each_degree([&](const auto degree) {
      this->template sum_points<degree>(column, dst);
    });
    dst.compress(VectorOperation::add);
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::sum_points(const PointColumn column, Field &dst) const
  {
    PointBatch<dim, degree, double> point;
    const double                   *mass = points.data(PointColumn::mass);
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        if (occupancy.degree(cell) != degree || is_lumped(cell))
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
        const auto nodes = occupancy.template unknowns<degree>(cell);
        if (dst.n_blocks() == 2)
          nodes.add_to_zeros(sum, dst.block(1).begin());
        nodes.add(sum, dst.block(0).begin());
      }
  }

  template <int dim>
  template <int degree>
  void
  MassMatrix<dim>::add_edge_cells(Field &dst, const Field &src) const
  {
    constexpr unsigned int n           = Basis<dim, degree>::n_nodes;
    const bool             with_unseen = src.n_blocks() == 2;
    for (const EdgeCell &edge_cell : edge_cells)
      {
        if (occupancy.degree(edge_cell.cell) != degree)
          continue;
        const auto nodes = occupancy.template unknowns<degree>(edge_cell.cell);
        double     values[dim][n], product[dim][n] = {};
        if (with_unseen)
          nodes.read(src.block(0).begin(), src.block(1).begin(), values);
        else
          nodes.read(src.block(0).begin(), values);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int b = 0; b < n; ++b)
              product[c][a] += edge_cell.values[a * n + b] * values[c][b];
        if (with_unseen)
          nodes.add_to_zeros(product, dst.block(1).begin());
        nodes.add(product, dst.block(0).begin());
      }
  }

  template <int dim>
  void
  MassMatrix<dim>::add_product(const Block  &block,
                               const double *src,
                               double       *dst) const
  {
    constexpr unsigned int most   = GhostFaceMatrix<dim, max_degree>::max_nodes;
    const unsigned int     n      = block.nodes.size();
    const double          *column = matrices[block.matrix].data();
    double                 product[dim][most];
    for (auto &component : product)
      std::fill_n(component, n, 0.);
    for (unsigned int b = 0; b < n; ++b, column += n)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double value = block.factor * src[dim * block.nodes[b] + c];
#pragma omp simd
          for (unsigned int a = 0; a < n; ++a)
            product[c][a] += column[a] * value;
        }
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int c = 0; c < dim; ++c)
        dst[dim * block.nodes[a] + c] += product[c][a];
  }

  template <int dim>
  void
  MassMatrix<dim>::vmult(Field &dst, const Field &src) const
  {
    src.update_ghost_values();
    dst = 0.;
    dst.zero_out_ghost_values();
    for (const Block &block : blocks)
      add_product(block, src.block(0).begin(), dst.block(0).begin());
    if (!edge_cells.empty())
      occupancy.for_each_degree([&](const auto degree) {
        this->template add_edge_cells<degree>(dst, src);
      });
    dst.compress(VectorOperation::add);
    src.zero_out_ghost_values();
    for (unsigned int k = 0; k < dst.n_blocks(); ++k)
      {
        auto       &result   = dst.block(k);
        const auto &argument = src.block(k);
        for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
          {
            if (linear_masses != nullptr)
              result.local_element(i) +=
                linear_masses->block(k).local_element(i) *
                argument.local_element(i);
            if (inverse_diagonal.block(k).local_element(i) == 0.)
              result.local_element(i) = argument.local_element(i);
          }
      }
  }

  template <int dim>
  void
  MassMatrix<dim>::solve(Field &v, const Field &b) const
  {
    v.zero_out_ghost_values();
    SolverControl       control(max_iterations,
                          std::max(tolerance * b.l2_norm(),
                                   std::numeric_limits<double>::min()));
    SolverCG<Field>     solver(control);
    const Jacobi<Field> jacobi{inverse_diagonal};
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
  MassMatrix<dim>::expand(Field             &v,
                          const Field       &b,
                          const Field       &lumped,
                          const unsigned int n_times) const
  {
    v.zero_out_ghost_values();
    Field product(v);
    for (unsigned int step = 0; step < n_times; ++step)
      {
        vmult(product, v);
        for (unsigned int k = 0; k < v.n_blocks(); ++k)
          for (unsigned int i = 0; i < v.block(k).locally_owned_size(); ++i)
            if (const double mass = lumped.block(k).local_element(i); mass > 0.)
              v.block(k).local_element(i) +=
                (b.block(k).local_element(i) -
                 product.block(k).local_element(i)) /
                mass;
      }
  }

  template class MassMatrix<2>;
  template class MassMatrix<3>;
} // namespace seiche
