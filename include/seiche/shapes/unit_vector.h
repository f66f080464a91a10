// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_shapes_unit_vector_h
#define seiche_shapes_unit_vector_h

#include <deal.II/base/tensor.h>

namespace seiche
{
  /// Upwards for a gradient that is zero: at a centre all directions are as
  /// good.
  template <int dim>
  dealii::Tensor<1, dim>
  unit_vector(const dealii::Tensor<1, dim> &gradient)
  {
    const double           norm = gradient.norm();
    dealii::Tensor<1, dim> up;
    up[dim - 1] = 1.;
    return norm > 0. ? gradient / norm : up;
  }
} // namespace seiche

#endif
