// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_point_velocity_h
#define seiche_transfer_point_velocity_h

#include <seiche/space/occupancy.h>
#include <seiche/transfer/point_arrays.h>
#include <seiche/transfer/transfer.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>

namespace seiche
{
  /// Share of the velocity gradient that the points of a cell pass on. Few
  /// points define no gradient (one in dim dimensions takes dim + 1): C would
  /// feed on itself through nodes of little mass, to which it extrapolates,
  /// and spray explode. What counts is how densely they lie in the part of the
  /// cell that is outside of the solids, @p wet_share (doc/theory.md (7.1a)).
  template <int dim>
  double
  gradient_share(const unsigned int n_points, const double wet_share)
  {
    return wet_share * (dim + 2.) <= n_points ?
             1. :
             std::max(0., (n_points / wet_share - 1.) / (dim + 1.));
  }



  /// The linear velocity v_p + C_p (x - x_p) that a point passes on
  /// (doc/theory.md (7.1)).
  template <int dim>
  class PointVelocity
  {
  public:
    PointVelocity(const PointArrays<dim, const PointCloud<dim>> &point_arrays,
                  const GradientUse                              use,
                  const PointCloud<dim>                         &points,
                  const Occupancy<dim>                          &occupancy,
                  const unsigned int                             cell)
      : arrays(point_arrays)
      , share(
          use == GradientUse::none ?
            0. :
            gradient_share<dim>(points.n_points_in(cell),
                                occupancy.mesh_nodes.cut_walls.wet_share(cell)))
      , fitted(use == GradientUse::fitted)
    {
      if (fitted)
        fit(points, cell);
    }

    bool
    is_affine() const
    {
      return share > 0.;
    }

    /// Component c at the point, and its derivative in direction d.
    double
    value(const std::size_t p, const unsigned int c) const
    {
      if (!fitted)
        return arrays.velocity[c][p];
      double result = mean[c];
      for (unsigned int d = 0; d < dim; ++d)
        result += slope[c][d] * (arrays.position[d][p] - centre[d]);
      return result;
    }

    double
    derivative(const std::size_t  p,
               const unsigned int c,
               const unsigned int d) const
    {
      return fitted ? slope[c][d] : share * arrays.gradient[c * dim + d][p];
    }

    /// Component c at @p arm from the point [m].
    double
    value_beside(const std::size_t             p,
                 const unsigned int            c,
                 const dealii::Tensor<1, dim> &arm) const
    {
      double result = value(p, c);
      if (is_affine())
        for (unsigned int d = 0; d < dim; ++d)
          result += derivative(p, c, d) * arm[d];
      return result;
    }

  private:
    /// The linear field that is closest to the velocities of the cell's
    /// points, weighted by mass (Taylor least squares: Wobbes, Moller,
    /// Galavi, Vuik 2019, with a linear basis). Points on a line or a plane
    /// define no derivative across it, and points near one hardly any.
    void
    fit(const PointCloud<dim> &points, const unsigned int cell)
    {
      const auto &geometry = points.locator.cells.geometry(cell);
      double      mass     = 0.;
      for (const std::size_t p : points.points_in(cell))
        {
          mass += arrays.mass[p];
          for (unsigned int d = 0; d < dim; ++d)
            {
              centre[d] += arrays.mass[p] * arrays.position[d][p];
              mean[d] += arrays.mass[p] * arrays.velocity[d][p];
            }
        }
      centre /= mass;
      mean /= mass;
      dealii::SymmetricTensor<2, dim> moments; // in cells, squared
      dealii::Tensor<2, dim>          products;
      for (const std::size_t p : points.points_in(cell))
        {
          const double           weight = arrays.mass[p] / mass;
          dealii::Tensor<1, dim> arm, deviation;
          for (unsigned int d = 0; d < dim; ++d)
            {
              arm[d]       = arrays.position[d][p] - centre[d];
              deviation[d] = arrays.velocity[d][p] - mean[d];
            }
          arm = geometry.to_unit(arm);
          moments += weight * symmetrize(outer_product(arm, arm));
          products += weight * outer_product(deviation, arm);
        }
      for (const auto &[spread, axis] : eigenvectors(moments))
        slope += share / std::max(spread, least_spread) *
                 outer_product(products * axis, axis);
      for (unsigned int c = 0; c < dim; ++c)
        slope[c] = geometry.to_unit(slope[c]);
    }

    /// Of points that define a derivative, mean square in cells (a uniform
    /// cell has 1/12): the slope is at most 1/sqrt(this), some 6, times
    /// the deviations of the velocities. Measured: doc/methods.md.
    static constexpr double least_spread = 0.03;

    const PointArrays<dim, const PointCloud<dim>> &arrays;
    const double                                   share;
    const bool                                     fitted;
    dealii::Tensor<1, dim>                         centre, mean;
    dealii::Tensor<2, dim>                         slope;
  };
} // namespace seiche

#endif
