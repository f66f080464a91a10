// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/space/shape_integrals.h>

namespace seiche
{
  using namespace dealii;

  const std::vector<double> &
  line_integrals(const unsigned int degree)
  {
    static const std::vector<double> linear    = {1. / 2., 1. / 2.},
                                     quadratic = {1. / 6., 4. / 6., 1. / 6.};
    AssertIndexRange(degree, 3);
    return degree == 1 ? linear : quadratic;
  }

  const std::vector<double> &
  hat_integrals(const unsigned int degree)
  {
    static const std::vector<double> one = {1. / 2., 1. / 2.},
                                     two = {1. / 4., 1. / 2., 1. / 4.};
    AssertIndexRange(degree, 3);
    return degree == 1 ? one : two;
  }
} // namespace seiche
