// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_point_block_h
#define seiche_transfer_point_block_h

#include <seiche/grid/occupancy.h>
#include <seiche/points/point_cloud.h>
#include <seiche/utilities/shape_functions.h>

#include <algorithm>

/**
 * @file
 * Nodal fields at a block of points of one cell: the kernels of the way from
 * the grid to the points. All loops have fixed bounds and vectorise over the
 * points of a block.
 */

namespace seiche
{
  /// Points are treated in blocks of this many: two vectors of AVX-512 or
  /// four of AVX2, which hides the latency of the sums.
  inline constexpr unsigned int n_lanes = 8;



  /// Nodal values of one cell, component by component.
  template <int dim, int degree>
  struct CellField
  {
    static constexpr unsigned int n_nodes = TensorShape<dim, degree>::n_nodes;

    double values[dim][n_nodes];

    void
    gather(const double         *vector,
           const Occupancy<dim> &occupancy,
           const unsigned int    cell)
    {
      const auto nodes = occupancy.template unknowns<degree>(cell);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int c = 0; c < dim; ++c)
          values[c][i] = vector[dim * nodes[i] + c];
      for (unsigned int c = 0; c < dim; ++c)
        nodes.expand(values[c]);
    }
  };



  /// Shape functions at the points of one block.
  template <int dim, int degree>
  struct Block
  {
    using Shape                           = TensorShape<dim, degree>;
    static constexpr unsigned int n_nodes = Shape::n_nodes;

    double N[n_nodes][n_lanes];
    double gradient[n_nodes][dim][n_lanes]; // at t_n, [1/m]

    /// Lanes beyond @p n_filled repeat the first point.
    template <typename Arrays>
    void
    reinit(const Arrays                 &arrays,
           const std::size_t             first,
           const unsigned int            n_filled,
           const dealii::Point<dim>     &lower,
           const dealii::Tensor<1, dim> &extent)
    {
      double unit[dim][n_lanes];
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double inverse = 1. / extent[d];
          for (unsigned int l = 0; l < n_lanes; ++l)
            unit[d][l] =
              (arrays.position[d][first + (l < n_filled ? l : 0)] - lower[d]) *
              inverse;
        }
      Shape::evaluate_lanes(unit, N, gradient);
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double inverse = 1. / extent[d];
          for (unsigned int i = 0; i < n_nodes; ++i)
            for (unsigned int l = 0; l < n_lanes; ++l)
              gradient[i][d][l] *= inverse;
        }
    }

    /// result [n_lanes] = sum_I N_I nodal_I
    void
    value(const double (&nodal)[n_nodes], double (&result)[n_lanes]) const
    {
      for (unsigned int l = 0; l < n_lanes; ++l)
        result[l] = N[0][l] * nodal[0];
      for (unsigned int i = 1; i < n_nodes; ++i)
        for (unsigned int l = 0; l < n_lanes; ++l)
          result[l] += N[i][l] * nodal[i];
    }

    /// result [dim][dim][n_lanes]: d field_c / d x_d, plus the identity if
    /// asked for.
    void
    field_gradient(const CellField<dim, degree> &field,
                   const bool                    add_identity,
                   double (&result)[dim][dim][n_lanes]) const
    {
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double start = add_identity && c == d ? 1. : 0.;
            for (unsigned int l = 0; l < n_lanes; ++l)
              result[c][d][l] = start;
            for (unsigned int i = 0; i < n_nodes; ++i)
              for (unsigned int l = 0; l < n_lanes; ++l)
                result[c][d][l] += gradient[i][d][l] * field.values[c][i];
          }
    }
  };



  /// Cofactors of F [dim][dim][n_lanes]: F^-1_ij = cofactor_ji / det F.
  template <int dim>
  void
  determinant_and_cofactors(const double (&F)[dim][dim][n_lanes],
                            double (&det)[n_lanes],
                            double (&cofactor)[dim][dim][n_lanes])
  {
    for (unsigned int l = 0; l < n_lanes; ++l)
      {
        if constexpr (dim == 2)
          {
            cofactor[0][0][l] = F[1][1][l];
            cofactor[0][1][l] = -F[1][0][l];
            cofactor[1][0][l] = -F[0][1][l];
            cofactor[1][1][l] = F[0][0][l];
          }
        else
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              {
                const unsigned int i1 = (i + 1) % dim, i2 = (i + 2) % dim;
                const unsigned int j1 = (j + 1) % dim, j2 = (j + 2) % dim;
                cofactor[i][j][l] =
                  F[i1][j1][l] * F[i2][j2][l] - F[i1][j2][l] * F[i2][j1][l];
              }
        det[l] = 0.;
        for (unsigned int j = 0; j < dim; ++j)
          det[l] += F[0][j][l] * cofactor[0][j][l];
      }
  }



  /// Calls action(cell, first point, number of points) for all blocks of
  /// the occupied cells, begin(cell) before the first one of a cell; a cell for
  /// which that is false is passed over.
  template <int dim, typename Begin, typename Action>
  void
  for_each_block(const Occupancy<dim>  &occupancy,
                 const PointCloud<dim> &points,
                 const Begin           &begin,
                 const Action          &action)
  {
    for (const unsigned int cell : occupancy.occupied_cells())
      {
        if (!begin(cell))
          continue;
        const std::size_t end = points.first_point(cell + 1);
        for (std::size_t p = points.first_point(cell); p < end; p += n_lanes)
          action(cell,
                 p,
                 static_cast<unsigned int>(
                   std::min<std::size_t>(n_lanes, end - p)));
      }
  }
} // namespace seiche

#endif
