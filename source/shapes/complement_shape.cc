// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/composed_shapes.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class ComplementShape : public Shape<dim>
    {
    public:
      ComplementShape(ShapePointer<dim>     &&shape,
                      const BoundingBox<dim> &domain_box)
        : inside(std::move(shape))
        , domain(domain_box)
      {}

      double
      distance(const Point<dim> &x) const override
      {
        return -inside->distance(x);
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        return -inside->normal(x);
      }

      double
      level(const Point<dim> &x) const override
      {
        return -inside->level(x);
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        return domain;
      }

      bool
      is_endless() const override
      {
        return true;
      }

      bool
      bounds_distance() const override
      {
        return inside->bounds_distance();
      }

    private:
      const ShapePointer<dim> inside;
      const BoundingBox<dim>  domain;
    };
  } // namespace

  template <int dim>
  ShapePointer<dim>
  complement_shape(ShapePointer<dim> &&shape, const BoundingBox<dim> &domain)
  {
    return std::make_unique<ComplementShape<dim>>(std::move(shape), domain);
  }

  template ShapePointer<2>
  complement_shape<2>(ShapePointer<2> &&, const BoundingBox<2> &);
  template ShapePointer<3>
  complement_shape<3>(ShapePointer<3> &&, const BoundingBox<3> &);
} // namespace seiche
