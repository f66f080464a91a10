// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/solid_shapes.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class HalfSpaceShape : public Shape<dim>
    {
    public:
      HalfSpaceShape(const Point<dim>       &point_of_plane,
                     const Tensor<1, dim>   &outward,
                     const BoundingBox<dim> &whole)
        : point(point_of_plane)
        , unit_normal(outward / outward.norm())
        , domain(whole)
      {}

      double
      distance(const Point<dim> &x) const override
      {
        return (x - point) * unit_normal;
      }

      Tensor<1, dim>
      normal(const Point<dim> &) const override
      {
        return unit_normal;
      }

      bool
      is_endless() const override
      {
        return true;
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        return domain;
      }

    private:
      const Point<dim>       point;
      const Tensor<1, dim>   unit_normal;
      const BoundingBox<dim> domain;
    };
  } // namespace

  template <int dim>
  ShapePointer<dim>
  half_space_shape(const Point<dim>       &point,
                   const Tensor<1, dim>   &outward,
                   const BoundingBox<dim> &domain)
  {
    return std::make_unique<HalfSpaceShape<dim>>(point, outward, domain);
  }

  template ShapePointer<2>
  half_space_shape(const Point<2> &,
                   const Tensor<1, 2> &,
                   const BoundingBox<2> &);
  template ShapePointer<3>
  half_space_shape(const Point<3> &,
                   const Tensor<1, 3> &,
                   const BoundingBox<3> &);
} // namespace seiche
