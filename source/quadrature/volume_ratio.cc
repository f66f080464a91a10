// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/quadrature/volume_ratio.h>

#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  LinearRatio<dim>
  ratio_of(const PointCloud<dim> &points,
           const unsigned int     cell,
           const VolumeRatio      ratio)
  {
    if (ratio == VolumeRatio::one || points.n_points_in(cell) == 0)
      return {};
    const double *volume = points.data(PointColumn::initial_volume);
    const double *J_p    = points.data(PointColumn::volume_ratio);
    const auto    unit   = [&](const std::size_t p) {
      return points.locator.cells.geometry(cell).to_unit(points.position(p));
    };
    LinearRatio<dim> J;
    Tensor<1, dim>   center;
    double           sum = 0., total = 0.;
    J.least   = std::numeric_limits<double>::max();
    J.largest = 0.;
    for (const std::size_t p : points.points_in(cell))
      {
        total += volume[p];
        sum += volume[p] * J_p[p];
        center += volume[p] * (unit(p) - Point<dim>());
        J.least   = std::min(J.least, J_p[p]);
        J.largest = std::max(J.largest, J_p[p]);
      }
    J.mean   = sum / total;
    J.center = Point<dim>() + center / total;
    if (ratio == VolumeRatio::mean)
      return J;

    Tensor<2, dim> moment;
    Tensor<1, dim> product;
    for (const std::size_t p : points.points_in(cell))
      {
        const Tensor<1, dim> arm    = unit(p) - J.center;
        const double         weight = volume[p] / total;
        moment += weight * outer_product(arm, arm);
        product += weight * (J_p[p] - J.mean) * arm;
      }
    // a uniform cell has 1/12 on the diagonal
    if (determinant(moment) > 0.1 * std::pow(1. / 12., dim))
      J.slope = invert(moment) * product;
    return J;
  }

  template LinearRatio<2>
  ratio_of(const PointCloud<2> &, const unsigned int, const VolumeRatio);
  template LinearRatio<3>
  ratio_of(const PointCloud<3> &, const unsigned int, const VolumeRatio);
} // namespace seiche
