// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_compressed_rule_h
#define seiche_space_compressed_rule_h

#include <seiche/space/wet_part.h>

namespace seiche
{
  /**
   * Some of the points, with other positive weights, that have the same
   * integrals of all polynomials up to @p degree: at most as many as there are
   * of these (Tchakaloff's theorem; points are taken out one by one along null
   * vectors of the moments' matrix, Davis 1967). Weights must be positive.
   */
  template <int dim>
  std::vector<WeightedPoint<dim>>
  compressed_rule(const std::vector<WeightedPoint<dim>> &points,
                  const unsigned int                     degree);
} // namespace seiche

#endif
