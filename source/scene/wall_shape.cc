// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/wall_shape.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <limits>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  PlaneShape<dim>::PlaneShape(const BoxFace side_of_box,
                              const double  place_of_side)
    : side(side_of_box)
    , place(place_of_side)
  {}

  template <int dim>
  double
  PlaneShape<dim>::distance(const Point<dim> &x) const
  {
    return side.outward() * (place - x[side.direction()]);
  }

  template <int dim>
  Tensor<1, dim>
  PlaneShape<dim>::normal(const Point<dim> &) const
  {
    Tensor<1, dim> result;
    result[side.direction()] = -side.outward();
    return result;
  }

  template <int dim>
  BoxShape<dim>::BoxShape(const BoundingBox<dim> &box_of_obstacle)
    : box(box_of_obstacle)
  {}

  template <int dim>
  std::pair<double, BoxFace>
  BoxShape<dim>::nearest_face(const Point<dim> &x) const
  {
    std::pair<double, BoxFace> result(-std::numeric_limits<double>::max(), 0);
    for (const BoxFace face : GeometryInfo<dim>::face_indices())
      {
        const unsigned int d  = face.direction();
        const double distance = face.is_upper() ? x[d] - box.upper_bound(d) :
                                                  box.lower_bound(d) - x[d];
        if (distance > result.first)
          result = {distance, face};
      }
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  BoxShape<dim>::from_box(const Point<dim> &x) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] =
        x[d] - std::min(std::max(x[d], box.lower_bound(d)), box.upper_bound(d));
    return result;
  }

  template <int dim>
  double
  BoxShape<dim>::distance(const Point<dim> &x) const
  {
    const double beyond_face = nearest_face(x).first;
    return beyond_face > 0. ? from_box(x).norm() : beyond_face;
  }

  template <int dim>
  Tensor<1, dim>
  BoxShape<dim>::normal(const Point<dim> &x) const
  {
    const Tensor<1, dim> outside = from_box(x);
    if (outside.norm() > 0.)
      return outside / outside.norm();
    const BoxFace  face = nearest_face(x).second;
    Tensor<1, dim> result;
    result[face.direction()] = face.outward();
    return result;
  }

  template class PlaneShape<2>;
  template class PlaneShape<3>;
  template class BoxShape<2>;
  template class BoxShape<3>;
} // namespace seiche
