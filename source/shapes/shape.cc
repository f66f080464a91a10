// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/shape.h>
#include <seiche/shapes/unit_vector.h>

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
    return unit_vector(gradient);
  }

  template class Shape<2>;
  template class Shape<3>;
} // namespace seiche
