// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/density_projection.h>
#include <seiche/grid/point_shift.h>
#include <seiche/space/cell_laplacian.h>
#include <seiche/space/point_batch.h>

#include <deal.II/lac/diagonal_matrix.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Nodes from this fill of the inside on take part: not 1/2, which nodes of
    /// surfaces along grid lines have but for round-off.
    constexpr double least_inside = 0.51;

    constexpr double longest_shift = 0.1; // of the cell, each direction

    /// Of a node's fill (doc/theory.md (5.1)).
    constexpr double largest_excess = 1.;

    // the shift is small and comes again in the next step
    constexpr double       tolerance      = 1e-2;
    constexpr unsigned int max_iterations = 200;

  } // namespace

  template <int dim>
  DensityProjection<dim>::DensityProjection(const Fill<dim> &grid_fill,
                                            const double     density_rate)
    : fill(grid_fill)
    , occupancy(grid_fill.occupancy)
    , rate(density_rate)
  {}

  template <int dim>
  void
  DensityProjection<dim>::apply(const double            cells,
                                const BoundingBox<dim> &domain,
                                PointCloud<dim>        &points)
  {
    const double share = std::min(1., rate * cells);
    if (share == 0.)
      return;
    find_laplacians_at_walls();
    choose_nodes();
    find_potential(share);
    move(domain, points);
  }

  template <int dim>
  void
  DensityProjection<dim>::find_laplacians_at_walls()
  {
    at_walls.clear();
    const CutWalls<dim> &walls = occupancy.mesh_nodes.cut_walls;
    if (!walls.exist())
      return;
    PointBatch<dim, 1, double> here;
    for (const unsigned int cell : occupancy.cells.occupied())
      if (walls.cuts(cell))
        {
          const auto &geometry = occupancy.locator.cells.geometry(cell);
          auto       &K        = at_walls[cell].K;
          for (unsigned int a = 0; a < Laplacian::n_nodes; ++a)
            std::fill_n(K[a], Laplacian::n_nodes, 0.);
          for (const WeightedPoint<dim> &point : walls.whole(cell).points)
            {
              here.reinit(geometry, point.unit);
              for (unsigned int a = 0; a < Laplacian::n_nodes; ++a)
                for (unsigned int b = 0; b < Laplacian::n_nodes; ++b)
                  for (unsigned int d = 0; d < dim; ++d)
                    K[a][b] += point.weight * geometry.measure *
                               here.gradient_n[d][a] * here.gradient_n[d][b];
            }
        }
  }

  template <int dim>
  const typename DensityProjection<dim>::Laplacian &
  DensityProjection<dim>::laplacian(const unsigned int cell,
                                    Laplacian         &of_box) const
  {
    const auto at_wall = at_walls.find(cell);
    if (at_wall != at_walls.end())
      return at_wall->second;
    of_box.reinit(occupancy.locator.cells.geometry(cell));
    return of_box;
  }

  template <int dim>
  void
  DensityProjection<dim>::choose_nodes()
  {
    const Vector &f = fill.nodal_fill(), &inside = fill.surface().nodal_fill();
    inverse_diagonal.reinit(occupancy.nodes.partitioner());
    Laplacian of_box;
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const auto         &K     = laplacian(cell, of_box).K;
        const unsigned int *nodes = occupancy.nodes.of_cell(cell);
        for (unsigned int v = 0; v < Laplacian::n_nodes; ++v)
          inverse_diagonal.local_element(
            nodes[vertex_node<dim>(occupancy.fe.degree, v)]) += K[v][v];
      }
    inverse_diagonal.compress(VectorOperation::add);
    is_free.reinit(inverse_diagonal);
    bool all_free = true;
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      {
        const double diagonal = inverse_diagonal.local_element(i);
        const bool   free = diagonal > 0. && occupancy.nodes.volume(i) > 0. &&
                          ((inside.local_element(i) > least_inside &&
                            !occupancy.constraints.leaves_wall(i)) ||
                           f.local_element(i) > 1.);
        all_free                 = all_free && (free || diagonal == 0.);
        is_free.local_element(i) = free;
        inverse_diagonal.local_element(i) = free ? 1. / diagonal : 1.;
      }
    any_fixed = Utilities::MPI::max(
                  all_free ? 0 : 1,
                  occupancy.locator.grid.triangulation.get_communicator()) > 0;
    is_free.update_ghost_values();
    free_cells.clear();
    for (const unsigned int cell : occupancy.cells.occupied())
      {
        const unsigned int *nodes = occupancy.nodes.of_cell(cell);
        if (std::any_of(nodes,
                        nodes + occupancy.nodes_per_cell(),
                        [&](const unsigned int node) {
                          return is_free.local_element(node) > 0.;
                        }))
          free_cells.push_back(cell);
      }
  }

  template <int dim>
  void
  DensityProjection<dim>::vmult(Vector &dst, const Vector &src) const
  {
    src.update_ghost_values();
    dst = 0.;
    dst.zero_out_ghost_values();
    Laplacian of_box;
    double    x[Laplacian::n_nodes], y[Laplacian::n_nodes];
    for (const unsigned int cell : free_cells)
      {
        const auto &K = laplacian(cell, of_box).K;
        occupancy.vertex_values(cell, src, x);
        for (unsigned int a = 0; a < Laplacian::n_nodes; ++a)
          {
            y[a] = 0.;
            for (unsigned int b = 0; b < Laplacian::n_nodes; ++b)
              y[a] += K[a][b] * x[b];
          }
        occupancy.add_vertex_values(cell, y, dst);
      }
    dst.compress(VectorOperation::add);
    src.zero_out_ghost_values();
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      if (is_free.local_element(i) == 0.)
        dst.local_element(i) = src.local_element(i);
  }

  template <int dim>
  void
  DensityProjection<dim>::find_potential(const double share)
  {
    potential.reinit(is_free);
    const Vector &f = fill.nodal_fill(), &inside = fill.surface().nodal_fill();
    Vector        sums(is_free);
    double        total = 0., volume = 0.;
    for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
      if (is_free.local_element(i) > 0.)
        {
          const double V = occupancy.nodes.volume(i);
          const double missing =
            std::max(inside.local_element(i) - f.local_element(i),
                     -largest_excess);
          sums.local_element(i) = share * missing * V;
          total += sums.local_element(i);
          volume += V;
        }
    if (!any_fixed)
      {
        const double mean =
          Utilities::MPI::sum(
            total, occupancy.locator.grid.triangulation.get_communicator()) /
          Utilities::MPI::sum(
            volume, occupancy.locator.grid.triangulation.get_communicator());
        for (unsigned int i = 0; i < occupancy.nodes.n_own(); ++i)
          if (is_free.local_element(i) > 0.)
            sums.local_element(i) -= mean * occupancy.nodes.volume(i);
      }
    SolverControl          control(max_iterations, tolerance * sums.l2_norm());
    SolverCG<Vector>       solver(control);
    DiagonalMatrix<Vector> preconditioner;
    preconditioner.get_vector() = inverse_diagonal;
    try
      {
        solver.solve(*this, potential, sums, preconditioner);
      }
    catch (const SolverControl::NoConvergence &)
      {
        // what is left comes again
        if (control.last_value() > control.initial_value())
          potential = 0.;
      }
    potential.update_ghost_values();
  }

  template <int dim>
  void
  DensityProjection<dim>::move(const BoundingBox<dim> &domain,
                               PointCloud<dim>        &points) const
  {
    PointBatch<dim, 1, double> point;
    double                     psi[point.n_nodes], s[point.n_nodes];
    for (const unsigned int cell : free_cells)
      {
        occupancy.vertex_values(cell, potential, psi);
        occupancy.vertex_values(cell, fill.inner_nodes(), s);
        const auto           &geometry = occupancy.locator.cells.geometry(cell);
        const PointShift<dim> shift(cell, points, domain);
        for (const std::size_t p : points.points_in(cell))
          {
            const Point<dim> place =
              geometry.clamped(points.position(p)); // it has moved
            point.reinit(geometry, geometry.to_unit(place));
            Tensor<1, dim> delta = geometry.to_unit(point.gradient(psi));
            for (unsigned int d = 0; d < dim; ++d)
              delta[d] = std::clamp(delta[d], -longest_shift, longest_shift);
            shift.apply(p, delta, point.value(s));
          }
      }
  }

  template class DensityProjection<2>;
  template class DensityProjection<3>;
} // namespace seiche
