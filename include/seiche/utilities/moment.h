// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_moment_h
#define seiche_utilities_moment_h

#include <deal.II/base/tensor.h>

#include <array>

namespace seiche
{
  template <int dim>
  constexpr unsigned int n_rotations = (dim == 2 ? 1 : 3);

  /// r x F: about x, y, z; in 2D about z alone.
  template <int dim>
  std::array<double, n_rotations<dim>>
  moment(const dealii::Tensor<1, dim> &arm, const dealii::Tensor<1, dim> &force)
  {
    if constexpr (dim == 2)
      return {{arm[0] * force[1] - arm[1] * force[0]}};
    else
      return {{arm[1] * force[2] - arm[2] * force[1],
               arm[2] * force[0] - arm[0] * force[2],
               arm[0] * force[1] - arm[1] * force[0]}};
  }
} // namespace seiche

#endif
