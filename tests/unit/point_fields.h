// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef tests_unit_point_fields_h
#define tests_unit_point_fields_h

#include <seiche/grid/grid_state.h>
#include <seiche/transfer/interpolate.h>

#include <deal.II/base/tensor.h>

#include <limits>
#include <vector>

#include "global_reductions.h"

// What points carry, what they see of a nodal field, and what both sum up to:
// references for tests of what passes between points and grid.
namespace
{
  using namespace dealii;
  using seiche::PointColumn;

  template <int dim>
  using Vectors = std::vector<Tensor<1, dim>>; // one a point



  template <int dim>
  Vectors<dim>
  column(const seiche::PointCloud<dim> &points, const PointColumn column)
  {
    Vectors<dim> result(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
      for (unsigned int d = 0; d < dim; ++d)
        result[p][d] = points.data(column, d)[p];
    return result;
  }



  /// A nodal field at the points, moved by a shift but of the same cell.
  template <int dim>
  Vectors<dim>
  at_points(const seiche::Occupancy<dim>                  &occupancy,
            const typename seiche::Occupancy<dim>::Vector &field,
            seiche::PointCloud<dim>                        points,
            const Tensor<1, dim>                          &shift = {})
  {
    for (unsigned int d = 0; d < dim; ++d)
      for (std::size_t p = 0; p < points.size(); ++p)
        points.data(PointColumn::position, d)[p] += shift[d];
    seiche::interpolate_to_points(occupancy,
                                  field,
                                  PointColumn::velocity,
                                  points);
    return column(points, PointColumn::velocity);
  }



  /// Its gradients by central differences, exact in cells of degrees 1 and 2.
  template <int dim>
  std::vector<Tensor<2, dim>>
  gradients_at_points(const seiche::Occupancy<dim>                  &occupancy,
                      const typename seiche::Occupancy<dim>::Vector &field,
                      const seiche::PointCloud<dim>                 &points)
  {
    std::vector<Tensor<2, dim>> result(points.size());
    for (unsigned int d = 0; d < dim; ++d)
      {
        Tensor<1, dim> step;
        step[d]          = 0.01;
        const auto after = at_points(occupancy, field, points, step);
        const auto ahead = at_points(occupancy, field, points, -step);
        for (std::size_t p = 0; p < points.size(); ++p)
          for (unsigned int c = 0; c < dim; ++c)
            result[p][c][d] = (after[p][c] - ahead[p][c]) / (2. * step[d]);
      }
    return result;
  }



  /// Whether all points of all ranks are right; n on this one.
  template <typename Condition>
  bool
  for_all(const std::size_t n, const Condition &is_right)
  {
    unsigned int n_wrong = 0;
    for (std::size_t p = 0; p < n; ++p)
      n_wrong += is_right(p) ? 0 : 1;
    return global_sum(n_wrong) == 0;
  }



  /// The share f with v = f a + (1 - f) b at all points; NaN if there is none.
  template <int dim>
  double
  share_between(const Vectors<dim> &v,
                const Vectors<dim> &a,
                const Vectors<dim> &b,
                const double        tolerance)
  {
    double product = 0., square = 0.;
    for (std::size_t p = 0; p < v.size(); ++p)
      {
        product += (v[p] - b[p]) * (a[p] - b[p]);
        square += (a[p] - b[p]).norm_square();
      }
    const double f = global_sum(product) / global_sum(square);
    return for_all(v.size(),
                   [&](const std::size_t p) {
                     return (v[p] - f * a[p] - (1. - f) * b[p]).norm() <
                            tolerance;
                   }) ?
             f :
             std::numeric_limits<double>::quiet_NaN();
  }



  /// Sums over points or nodes of all ranks.
  template <int dim>
  struct Ledger
  {
    double         mass = 0., energy = 0.;
    Tensor<1, dim> momentum;
    Tensor<2, dim> spin; // sum of m x v, whose skew part is conserved

    void
    add(const Point<dim> &x, const Tensor<1, dim> &v, const double m)
    {
      mass += m;
      momentum += m * v;
      energy += 0.5 * m * v.norm_square();
      spin += m * (outer_product(x, v) - outer_product(v, x));
    }

    Ledger
    total() const
    {
      Ledger result;
      result.mass     = global_sum(mass);
      result.energy   = global_sum(energy);
      result.momentum = global_sum(momentum);
      result.spin     = global_sum(spin);
      return result;
    }
  };



  template <int dim>
  Ledger<dim>
  of_points(const seiche::PointCloud<dim> &points, const Vectors<dim> &velocity)
  {
    Ledger<dim> result;
    for (std::size_t p = 0; p < points.size(); ++p)
      result.add(points.position(p),
                 velocity[p],
                 points.data(PointColumn::mass)[p]);
    return result.total();
  }



  template <int dim>
  Ledger<dim>
  of_nodes(const seiche::Occupancy<dim>                  &occupancy,
           const seiche::GridState<dim>                  &state,
           const typename seiche::GridState<dim>::Vector &velocity)
  {
    Ledger<dim> result;
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        Tensor<1, dim> v;
        for (unsigned int d = 0; d < dim; ++d)
          v[d] = velocity.local_element(dim * node + d);
        result.add(occupancy.nodes.position(node),
                   v,
                   state.mass.local_element(node));
      }
    return result.total();
  }
} // namespace

#endif
