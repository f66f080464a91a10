// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/solid_shapes.h>
#include <seiche/utilities/box_face.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <utility>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class BoxShape : public Shape<dim>
    {
    public:
      explicit BoxShape(const BoundingBox<dim> &extent)
        : box(extent)
      {}

      double
      distance(const Point<dim> &x) const override
      {
        const double beyond_face = nearest_face(x).first;
        return beyond_face > 0. ? from_box(x).norm() : beyond_face;
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        const Tensor<1, dim> outside = from_box(x);
        if (outside.norm() > 0.)
          return outside / outside.norm();
        const BoxFace  face = nearest_face(x).second;
        Tensor<1, dim> result;
        result[face.direction()] = face.outward();
        return result;
      }

      double
      level(const Point<dim> &x) const override
      {
        return nearest_face(x).first;
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        return box;
      }

      double
      volume() const override
      {
        return box.volume();
      }

      bool
      is_box() const override
      {
        return true;
      }

      BoundingBox<dim>
      lattice_box(const BoundingBox<dim> &cell) const override
      {
        auto corners = cell.get_boundary_points();
        for (unsigned int d = 0; d < dim; ++d)
          {
            corners.first[d]  = std::max(corners.first[d], box.lower_bound(d));
            corners.second[d] = std::min(corners.second[d], box.upper_bound(d));
            corners.second[d] = std::max(corners.second[d], corners.first[d]);
          }
        return BoundingBox<dim>(corners);
      }

    private:
      /// From the nearest place of the box, for one outside; zero inside.
      Tensor<1, dim>
      from_box(const Point<dim> &x) const
      {
        Tensor<1, dim> result;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] = x[d] - std::min(std::max(x[d], box.lower_bound(d)),
                                      box.upper_bound(d));
        return result;
      }

      /// The face that a place inside is nearest to, and its signed distance
      /// [m].
      std::pair<double, BoxFace>
      nearest_face(const Point<dim> &x) const
      {
        std::pair<double, BoxFace> result(-std::numeric_limits<double>::max(),
                                          0);
        for (const BoxFace face : GeometryInfo<dim>::face_indices())
          {
            const unsigned int d        = face.direction();
            const double       distance = face.is_upper() ?
                                            x[d] - box.upper_bound(d) :
                                            box.lower_bound(d) - x[d];
            if (distance > result.first)
              result = {distance, face};
          }
        return result;
      }

      const BoundingBox<dim> box;
    };
  } // namespace

  template <int dim>
  ShapePointer<dim>
  box_shape(const BoundingBox<dim> &box)
  {
    return std::make_unique<BoxShape<dim>>(box);
  }

  template ShapePointer<2>
  box_shape(const BoundingBox<2> &);
  template ShapePointer<3>
  box_shape(const BoundingBox<3> &);
} // namespace seiche
