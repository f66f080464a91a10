// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/residual_projection.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/lac/solver_cg.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double       tolerance      = 1e-8; // of the right-hand side
    constexpr unsigned int max_iterations = 500;

    /// Multiplication with a diagonal, as deal.II's solvers want it.
    template <typename BlockVector>
    struct Diagonal
    {
      const BlockVector &values;

      void
      vmult(BlockVector &dst, const BlockVector &src) const
      {
        dst = src;
        dst.zero_out_ghost_values();
        for (unsigned int b = 0; b < dst.n_blocks(); ++b)
          dst.block(b).scale(values.block(b));
      }
    };
  } // namespace

  template <int dim>
  ResidualProjection<dim>::ResidualProjection(Assembler<dim>        &a,
                                              const Quadrature<dim> &rule,
                                              const Occupancy<dim>  &occupied)
    : assembler(a)
    , quadrature(rule)
    , occupancy(occupied)
    , active(a.formulation.residual_moments != nullptr)
    , lumped(active && a.formulation.subscales->projects_lumped)
    , n_updates(
        active ? a.formulation.subscales->parameters.projection_updates : 0)
  {}

  template <int dim>
  void
  ResidualProjection<dim>::begin(const GridState<dim> &state)
  {
    if (!active)
      return;
    projected.reinit(state.solution);
    sums.reinit(state.solution);
    projected.update_ghost_values();
    assembler.set_projection(&projected);
    make_diagonal();
    project(state);
  }

  template <int dim>
  bool
  ResidualProjection<dim>::update(const GridState<dim> &state,
                                  const unsigned int    iteration)
  {
    if (!active || iteration > n_updates)
      return false;
    project(state);
    return true;
  }

  template <int dim>
  void
  ResidualProjection<dim>::project(const GridState<dim> &state)
  {
    assembler.residual_moments(state, sums);
    projected.zero_out_ghost_values();
    if (lumped)
      Diagonal<BlockVector>{inverse_diagonal}.vmult(projected, sums);
    else
      {
        SolverControl         control(max_iterations,
                              std::max(tolerance * sums.l2_norm(),
                                       std::numeric_limits<double>::min()));
        SolverCG<BlockVector> solver(control);
        try
          {
            solver.solve(*this,
                         projected,
                         sums,
                         Diagonal<BlockVector>{inverse_diagonal});
          }
        catch (const SolverControl::NoConvergence &)
          {
            throw NumericalError("the projection of the residuals did not "
                                 "converge; set Formulation/Projection mass = "
                                 "lumped.");
          }
      }
    projected.update_ghost_values();
  }

  template <int dim>
  void
  ResidualProjection<dim>::make_diagonal()
  {
    inverse_diagonal.reinit(sums);
    for (const unsigned int cell : occupancy.cells.occupied())
      with_degree(occupancy.degree(cell), [&](const auto degree) {
        this->template add_diagonal<degree>(cell);
      });
    inverse_diagonal.block(1).compress(VectorOperation::add);
    for (unsigned int i = 0; i < inverse_diagonal.block(1).locally_owned_size();
         ++i)
      {
        double &value = inverse_diagonal.block(1).local_element(i);
        value         = value > 0. ? 1. / value : 0.;
        for (unsigned int c = 0; c < dim; ++c)
          inverse_diagonal.block(0).local_element(dim * i + c) = value;
      }
  }

  template <int dim>
  void
  ResidualProjection<dim>::vmult(BlockVector &dst, const BlockVector &src) const
  {
    src.update_ghost_values();
    dst = 0.;
    dst.zero_out_ghost_values();
    for (const unsigned int cell : occupancy.cells.occupied())
      with_degree(occupancy.degree(cell), [&](const auto degree) {
        this->template add_products<degree>(cell, src, dst);
      });
    dst.compress(VectorOperation::add);
    src.zero_out_ghost_values();
  }

  template <int dim>
  template <int degree>
  void
  ResidualProjection<dim>::add_diagonal(const unsigned int cell)
  {
    PointBatch<dim, degree> point;
    CellQuadrature<dim>     points;
    quadrature.get(cell, points);
    double weights[point.n_nodes] = {};
    points.for_each_batch(
      [&](const unsigned int q, const unsigned int, const Material &) {
        const auto unit = points.template point<Lanes>(q);
        point.reinit_values(unit);
        point.add_weights(unit);
        const Lanes volume = load<Lanes>(&points.volume[q]);
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          weights[a] +=
            sum(volume * (lumped ? point.weight(a) : point.N[a] * point.N[a]));
      });
    occupancy.template unknowns<degree>(cell).add(
      weights, inverse_diagonal.block(1).begin());
  }

  template <int dim>
  template <int degree>
  void
  ResidualProjection<dim>::add_products(const unsigned int cell,
                                        const BlockVector &src,
                                        BlockVector       &dst) const
  {
    PointBatch<dim, degree> point;
    CellQuadrature<dim>     points;
    quadrature.get(cell, points);
    const auto nodes = occupancy.template unknowns<degree>(cell);
    double     momentum[dim][point.n_nodes], constraint[point.n_nodes];
    double momenta[dim][point.n_nodes] = {}, constraints[point.n_nodes] = {};
    nodes.read_nodes(src.block(0).begin(), momentum);
    nodes.read(src.block(1).begin(), constraint);
    points.for_each_batch(
      [&](const unsigned int q, const unsigned int, const Material &) {
        point.reinit_values(points.template point<Lanes>(q));
        const Lanes volume = load<Lanes>(&points.volume[q]);
        const auto  add    = [&](const Lanes &value, double *products) {
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            products[a] += sum(volume * value * point.N[a]);
        };
        for (unsigned int c = 0; c < dim; ++c)
          add(point.value(momentum[c]), momenta[c]);
        add(point.value(constraint), constraints);
      });
    nodes.add_to_nodes(momenta, dst.block(0).begin());
    nodes.add(constraints, dst.block(1).begin());
  }

  template class ResidualProjection<2>;
  template class ResidualProjection<3>;
} // namespace seiche
