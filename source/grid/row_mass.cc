// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/grid/row_mass.h>
#include <seiche/space/point_batch.h>
#include <seiche/space/shape_integrals.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// sum_p m_p N of the cells at walls.
    template <int dim, int degree>
    void
    add_points(const PointCloud<dim>           &points,
               const Occupancy<dim>            &occupancy,
               typename Occupancy<dim>::Vector &sums)
    {
      const double                   *mass = points.data(PointColumn::mass);
      PointBatch<dim, degree, double> point;
      for (const unsigned int cell : occupancy.cells.occupied())
        {
          if (occupancy.degree(cell) != degree ||
              !touches_wall(occupancy, cell))
            continue;
          const auto &geometry = points.locator.cells.geometry(cell);
          double      of_cell[Basis<dim, degree>::n_nodes] = {};
          for (const std::size_t p : points.points_in(cell))
            {
              point.reinit_values(geometry.to_unit(points.position(p)));
              for (unsigned int a = 0; a < point.n_nodes; ++a)
                of_cell[a] += mass[p] * point.N[a];
            }
          occupancy.template unknowns<degree>(cell).add(of_cell, sums.begin());
        }
    }
  } // namespace

  template <int dim>
  RowMass<dim>::RowMass(const Occupancy<dim> &grid_occupancy, const bool needed)
    : occupancy(grid_occupancy)
    , is_needed(needed)
  {}

  template <int dim>
  void
  RowMass<dim>::reinit(const PointCloud<dim> &points)
  {
    const unsigned int degree = occupancy.fe.degree;
    if (degree == 1 || !is_needed)
      return;
    const auto &line = line_integrals(degree), &hats = hat_integrals(degree);
    typename Occupancy<dim>::Vector of_shapes(occupancy.nodes.partitioner()),
      of_hats(of_shapes);
    for (const unsigned int cell : occupancy.cells.occupied())
      if (touches_wall(occupancy, cell))
        {
          add_volume_integrals(occupancy, cell, line, of_shapes);
          add_volume_integrals(occupancy, cell, hats, of_hats);
        }
    typename Occupancy<dim>::Vector of_points(occupancy.nodes.partitioner());
    occupancy.for_each_degree([&](const auto cell_degree) {
      add_points<dim, cell_degree>(points, occupancy, of_points);
    });
    of_points.compress(VectorOperation::add);
    masses.assign(of_points.begin(),
                  of_points.begin() + occupancy.nodes.n_own());
    of_shapes.compress(VectorOperation::add);
    of_hats.compress(VectorOperation::add);
    factor.assign(occupancy.nodes.n_own(), 1.);
    // masters of hanging nodes may have sums without a meaning
    for (unsigned int node = 0; node < factor.size(); ++node)
      if (of_hats.local_element(node) > 0. &&
          of_shapes.local_element(node) > 0.)
        factor[node] =
          of_shapes.local_element(node) / of_hats.local_element(node);
  }

  template class RowMass<2>;
  template class RowMass<3>;
} // namespace seiche
