// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_quadrature_volume_ratio_h
#define seiche_quadrature_volume_ratio_h

#include <seiche/points/point_cloud.h>

#include <algorithm>

namespace seiche
{
  /// Volume ratio J_n of quadrature points. Material points have their own one
  /// if it is not one.
  enum class VolumeRatio
  {
    one,  ///< the fluid is incompressible: J is an error of the points' motion
    mean, ///< V0-weighted mean of the cell's points
    /// linear fit to the cell's points, for volumes that follow nodal means or
    /// the pressure: of second order. With volumes that follow the points' own
    /// gradients, whose linear part in a cell no equation controls, soft fluids
    /// are unstable (doc/methods.md, "Stability").
    linear
  };

  /// J_n in a cell: mean + slope.(x - center) within what points have.
  template <int dim>
  struct LinearRatio
  {
    dealii::Point<dim>     center; // in units of the cell
    dealii::Tensor<1, dim> slope;
    double                 mean = 1., least = 1., largest = 1.;

    double
    value(const dealii::Point<dim> &unit) const
    {
      return std::clamp(mean + slope * (unit - center), least, largest);
    }
  };

  /// J_n as VolumeRatio says. Linear: least squares, weighted by V0 (the
  /// mean jumps, by the gradient, whenever a point crosses a face).
  template <int dim>
  LinearRatio<dim>
  ratio_of(const PointCloud<dim> &points,
           const unsigned int     cell,
           const VolumeRatio      ratio);
} // namespace seiche

#endif
