// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/shape.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double difference = 1e-5; // of the box's longest edge
  }                                     // namespace

  template <int dim>
  Tensor<1, dim>
  Shape<dim>::normal(const Point<dim> &x) const
  {
    const BoundingBox<dim> box    = bounding_box();
    double                 length = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      length = std::max(length, box.side_length(d));
    Tensor<1, dim> gradient;
    for (unsigned int d = 0; d < dim; ++d)
      {
        Point<dim> before = x, behind = x;
        before[d] -= difference * length;
        behind[d] += difference * length;
        gradient[d] = distance(behind) - distance(before);
      }
    const double norm = gradient.norm();
    if (norm == 0.)
      gradient[dim - 1] = 1.; // at a centre all directions are as good
    return norm > 0. ? gradient / norm : gradient;
  }

  template class Shape<2>;
  template class Shape<3>;
} // namespace seiche
