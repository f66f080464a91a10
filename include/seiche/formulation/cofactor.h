// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_cofactor_h
#define seiche_formulation_cofactor_h

#include <deal.II/base/tensor.h>

namespace seiche
{
  /// cof(F), F^-T det F: what turns and stretches an area's normal.
  template <typename Number>
  dealii::Tensor<2, 2, Number>
  cofactor(const dealii::Tensor<2, 2, Number> &F)
  {
    dealii::Tensor<2, 2, Number> result;
    result[0][0] = F[1][1];
    result[0][1] = -F[1][0];
    result[1][0] = -F[0][1];
    result[1][1] = F[0][0];
    return result;
  }

  template <typename Number>
  dealii::Tensor<2, 3, Number>
  cofactor(const dealii::Tensor<2, 3, Number> &F)
  {
    dealii::Tensor<2, 3, Number> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const unsigned int k = (i + 1) % 3, l = (i + 2) % 3;
          const unsigned int m = (j + 1) % 3, n = (j + 2) % 3;
          result[i][j] = F[k][m] * F[l][n] - F[k][n] * F[l][m];
        }
    return result;
  }
} // namespace seiche

#endif
