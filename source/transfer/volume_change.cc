// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/point_block.h>
#include <seiche/transfer/volume_change.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Derivatives of the shape functions in the middle of the unit cell.
    template <int dim, int degree>
    struct CellMiddle
    {
      static constexpr unsigned int n_nodes = TensorShape<dim, degree>::n_nodes;

      double N[n_nodes], derivatives[n_nodes][dim];

      CellMiddle()
      {
        Point<dim> centre;
        for (unsigned int d = 0; d < dim; ++d)
          centre[d] = 0.5;
        TensorShape<dim, degree>::evaluate(centre, N, derivatives);
      }

      /// det(I + grad u)
      double
      determinant_of(const CellField<dim, degree> &u,
                     const Tensor<1, dim>         &extent) const
      {
        Tensor<2, dim> F;
        for (unsigned int d = 0; d < dim; ++d)
          {
            F[d][d] += 1.;
            for (unsigned int a = 0; a < n_nodes; ++a)
              for (unsigned int c = 0; c < dim; ++c)
                F[c][d] += derivatives[a][d] / extent[d] * u.values[c][a];
          }
        return determinant(F);
      }
    };



    /// sum N_I V times the cell's det(I + grad u), and sum N_I V.
    template <int dim, int degree>
    void
    add_cells(const Fill<dim>                 &fill,
              const PointCloud<dim>           &points,
              const GridState<dim>            &state,
              typename GridState<dim>::Vector &sum,
              typename GridState<dim>::Vector &weight)
    {
      constexpr unsigned int n_nodes = TensorShape<dim, degree>::n_nodes;
      constexpr double       equal   = 1. / n_nodes; // N_I may be negative
      const PointArrays<dim, const PointCloud<dim>> arrays(points);
      const Occupancy<dim>                         &occupancy = fill.occupancy;
      const double *initial = points.data(PointColumn::initial_volume);
      const auto   &locator = points.locator;

      const CellMiddle<dim, degree> middle;
      CellField<dim, degree>        u;
      Block<dim, degree>            block;
      double F[dim][dim][n_lanes], cofactor[dim][dim][n_lanes], det[n_lanes];
      for (const unsigned int cell : occupancy.occupied_cells())
        {
          if (occupancy.degree(cell) != degree)
            continue;
          u.gather(state.displacement().begin(), occupancy, cell);
          const bool        is_full         = fill.is_full(cell);
          double            shares[n_nodes] = {}, volume = 0., volume_then = 0.;
          const std::size_t end = points.first_point(cell + 1);
          for (std::size_t first = points.first_point(cell); first < end;
               first += n_lanes)
            {
              const unsigned int n =
                std::min<std::size_t>(n_lanes, end - first);
              block.reinit(arrays,
                           first,
                           n,
                           locator.lower_corner(cell),
                           locator.extent(cell));
              if (!is_full)
                {
                  block.field_gradient(u, /*add_identity=*/true, F);
                  determinant_and_cofactors<dim>(F, det, cofactor);
                }
              for (unsigned int l = 0; l < n; ++l)
                {
                  const double V =
                    arrays.volume_ratio[first + l] * initial[first + l];
                  volume += V;
                  if (!is_full)
                    volume_then += V * det[l];
                  for (unsigned int a = 0; a < n_nodes; ++a)
                    shares[a] += (degree == 1 ? block.N[a][l] : equal) * V;
                }
            }
          const double change =
            is_full     ? middle.determinant_of(u, locator.extent(cell)) :
            volume > 0. ? volume_then / volume :
                          1.;
          double sums[n_nodes];
          for (unsigned int a = 0; a < n_nodes; ++a)
            sums[a] = change * shares[a];
          const auto nodes = occupancy.template unknowns<degree>(cell);
          nodes.condense(sums);
          nodes.condense(shares);
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              sum.local_element(nodes[a]) += sums[a];
              weight.local_element(nodes[a]) += shares[a];
            }
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
    typename GridState<dim>::Vector result(occupancy.scalar_partitioner()),
      weight(occupancy.scalar_partitioner());
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
