// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/interpolate.h>
#include <seiche/transfer/point_block.h>

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
      using Shape                    = TensorShape<dim, degree>;
      constexpr unsigned int n_nodes = Shape::n_nodes;
      double                 N[n_nodes];
      CellField<dim, degree> nodal;
      for (const unsigned int cell : occupancy.occupied_cells())
        {
          nodal.gather(field.begin(), occupancy, cell);
          for (std::size_t p = points.first_point(cell);
               p < points.first_point(cell + 1);
               ++p)
            {
              Shape::values(points.locator.to_unit(cell, points.position(p)),
                            N);
              for (unsigned int c = 0; c < dim; ++c)
                {
                  double sum = 0.;
                  for (unsigned int a = 0; a < n_nodes; ++a)
                    sum += N[a] * nodal.values[c][a];
                  double &value = points.data(column, c)[p];
                  value         = keep * value + sum;
                }
            }
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
