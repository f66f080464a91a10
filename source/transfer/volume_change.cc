// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/volume_change.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// sum N_I V times the cell's det(I + grad u), and sum N_I V.
    template <int dim, int degree>
    void
    add_cells(const Fill<dim>                 &fill,
              const PointCloud<dim>           &points,
              const GridState<dim>            &state,
              typename GridState<dim>::Vector &sum_of_changes,
              typename GridState<dim>::Vector &weight)
    {
      constexpr unsigned int n_nodes = Basis<dim, degree>::n_nodes;
      constexpr double       equal   = 1. / n_nodes; // N_I may be negative
      const PointArrays<dim, const PointCloud<dim>> arrays(points);
      const Occupancy<dim>                         &occupancy = fill.occupancy;
      const double *initial = points.data(PointColumn::initial_volume);

      PointBatch<dim, degree>         batch;
      PointBatch<dim, degree, double> middle;
      double                          u[dim][n_nodes];
      for (const unsigned int cell : occupancy.cells.occupied())
        {
          if (occupancy.degree(cell) != degree)
            continue;
          const auto &geometry = points.locator.cells.geometry(cell);
          const auto  nodes    = occupancy.template unknowns<degree>(cell);
          nodes.read(state.displacement().begin(), u);
          const bool is_full         = fill.is_full(cell);
          double     shares[n_nodes] = {}, volume = 0., volume_then = 0.;
          for_each_range(points, cell, [&](const PointRange &range) {
            const auto unit = geometry.to_unit(range.position(arrays.position));
            if (is_full)
              batch.reinit_values(unit);
            else
              batch.reinit(geometry, unit);
            const Lanes V =
              range.load_weights(initial) * range.load(arrays.volume_ratio);
            volume += sum(V);
            if (!is_full)
              volume_then +=
                sum(V * determinant(identity_plus(batch.gradient(u))));
            for (unsigned int a = 0; a < n_nodes; ++a)
              shares[a] += degree == 1 ? sum(batch.N[a] * V) : equal * sum(V);
          });
          double change = 1.;
          if (is_full)
            {
              middle.reinit(geometry, geometry.unit_centre());
              change = determinant(identity_plus(middle.gradient(u)));
            }
          else if (volume > 0.)
            change = volume_then / volume;
          double changes[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            changes[a] = change * shares[a];
          nodes.add(changes, sum_of_changes.begin());
          nodes.add(shares, weight.begin());
        }
    }
  } // namespace

  template <int dim>
  typename GridState<dim>::Vector
  nodal_volume_change(const Fill<dim>       &fill,
                      const PointCloud<dim> &points,
                      const GridState<dim>  &state)
  {
    const Occupancy<dim>           &occupancy = fill.occupancy;
    typename GridState<dim>::Vector result(occupancy.nodes.partitioner()),
      weight(occupancy.nodes.partitioner());
    occupancy.for_each_degree([&](const auto degree) {
      add_cells<dim, decltype(degree)::value>(
        fill, points, state, result, weight);
    });
    result.compress(VectorOperation::add);
    weight.compress(VectorOperation::add);
    for (unsigned int i = 0; i < result.locally_owned_size(); ++i)
      if (weight.local_element(i) > 0.)
        result.local_element(i) /= weight.local_element(i);
    result.update_ghost_values();
    return result;
  }

  template GridState<2>::Vector
  nodal_volume_change(const Fill<2> &,
                      const PointCloud<2> &,
                      const GridState<2> &);
  template GridState<3>::Vector
  nodal_volume_change(const Fill<3> &,
                      const PointCloud<3> &,
                      const GridState<3> &);
} // namespace seiche
