// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/transfer/point_block.h>
#include <seiche/transfer/volume_change.h>

#include <numeric>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// det(I + grad u), @p derivatives of the shape functions in the unit cell
    /// [n_nodes][dim], @p extent of the cell [m].
    template <int dim, int degree>
    double
    determinant_of(const CellField<dim, degree> &u,
                   const double                  derivatives[][dim],
                   const Tensor<1, dim>         &extent)
    {
      Tensor<2, dim> F;
      for (unsigned int d = 0; d < dim; ++d)
        {
          F[d][d] += 1.;
          for (unsigned int a = 0; a < u.n_nodes; ++a)
            for (unsigned int c = 0; c < dim; ++c)
              F[c][d] += derivatives[a][d] / extent[d] * u.values[c][a];
        }
      return determinant(F);
    }

    template <int dim, int degree>
    void
    add_cells(const Occupancy<dim>            &occupancy,
              const PointCloud<dim>           &points,
              const GridState<dim>            &state,
              typename GridState<dim>::Vector &sum,
              typename GridState<dim>::Vector &weight)
    {
      using Shape                    = TensorShape<dim, degree>;
      constexpr unsigned int n_nodes = Shape::n_nodes;
      const double          *mass    = points.data(PointColumn::mass);
      CellField<dim, degree> u;
      double                 N[n_nodes], derivatives[n_nodes][dim];
      Point<dim>             centre;
      for (unsigned int d = 0; d < dim; ++d)
        centre[d] = 0.5;
      Shape::evaluate(centre, N, derivatives);
      for (const unsigned int cell : occupancy.occupied_cells())
        {
          u.gather(state.displacement().begin(), occupancy, cell);
          const double m = std::accumulate(mass + points.first_point(cell),
                                           mass + points.first_point(cell + 1),
                                           0.);
          const double det =
            determinant_of<dim, degree>(u,
                                        derivatives,
                                        points.locator.extent(cell));
          double sums[n_nodes], weights[n_nodes];
          std::fill_n(sums, n_nodes, m * det);
          std::fill_n(weights, n_nodes, m);
          occupancy.condense(cell, sums);
          occupancy.condense(cell, weights);
          for (unsigned int a = 0; a < n_nodes; ++a)
            {
              const unsigned int node = occupancy.cell_nodes(cell)[a];
              sum.local_element(node) += sums[a];
              weight.local_element(node) += weights[a];
            }
        }
    }
  } // namespace

  template <int dim>
  typename GridState<dim>::Vector
  nodal_volume_change(const Occupancy<dim>  &occupancy,
                      const PointCloud<dim> &points,
                      const GridState<dim>  &state)
  {
    typename GridState<dim>::Vector result(occupancy.scalar_partitioner()),
      weight(occupancy.scalar_partitioner());
    with_degree(occupancy.fe.degree, [&](const auto degree) {
      add_cells<dim, decltype(degree)::value>(
        occupancy, points, state, result, weight);
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
  nodal_volume_change(const Occupancy<2> &,
                      const PointCloud<2> &,
                      const GridState<2> &);
  template GridState<3>::Vector
  nodal_volume_change(const Occupancy<3> &,
                      const PointCloud<3> &,
                      const GridState<3> &);
} // namespace seiche
