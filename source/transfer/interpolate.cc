// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/points/point_range.h>
#include <seiche/space/point_batch.h>
#include <seiche/transfer/interpolate.h>

namespace seiche
{
  namespace
  {
    template <int dim, int degree>
    void
    interpolate(const Occupancy<dim>                  &occupancy,
                const typename Occupancy<dim>::Vector &field,
                const PointColumn                      column,
                PointCloud<dim>                       &points,
                const double                           keep)
    {
      PointBatch<dim, degree>         batch;
      std::array<const double *, dim> position;
      std::array<double *, dim>       values;
      for (unsigned int c = 0; c < dim; ++c)
        {
          position[c] = points.data(PointColumn::position, c);
          values[c]   = points.data(column, c);
        }
      double nodal[dim][batch.n_nodes];
      for (const unsigned int cell : occupancy.cells.occupied())
        {
          occupancy.template unknowns<degree>(cell).read(field.begin(), nodal);
          const auto &geometry = points.locator.cells.geometry(cell);
          for_each_range(points, cell, [&](const PointRange &range) {
            batch.reinit_values(geometry.to_unit(range.position(position)));
            for (unsigned int c = 0; c < dim; ++c)
              range.store(keep * range.load(values[c]) + batch.value(nodal[c]),
                          values[c]);
          });
        }
    }
  } // namespace

  template <int dim>
  void
  interpolate_to_points(const Occupancy<dim>                  &occupancy,
                        const typename Occupancy<dim>::Vector &field,
                        const PointColumn                      column,
                        PointCloud<dim>                       &points,
                        const double                           keep)
  {
    with_degree(occupancy.fe.degree, [&](const auto degree) {
      interpolate<dim, degree>(occupancy, field, column, points, keep);
    });
  }

#define INSTANTIATE(dim)                     \
  template void interpolate_to_points<dim>(  \
    const Occupancy<dim> &,                  \
    const typename Occupancy<dim>::Vector &, \
    const PointColumn,                       \
    PointCloud<dim> &,                       \
    const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
