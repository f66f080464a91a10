// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/composed_shapes.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The smallest box around the images of a box's corners.
    template <int dim, typename Map>
    BoundingBox<dim>
    box_of_corners(const BoundingBox<dim> &box, const Map &map)
    {
      const Point<dim> first = map(box.vertex(0));
      BoundingBox<dim> result({first, first});
      for (unsigned int v = 1; v < (1u << dim); ++v)
        {
          const Point<dim> corner = map(box.vertex(v));
          result.merge_with(BoundingBox<dim>({corner, corner}));
        }
      return result;
    }

    template <int dim>
    class PlacedShape : public Shape<dim>
    {
    public:
      PlacedShape(const SharedShape<dim> &placed,
                  const Placement<dim>   &its_placement,
                  const BoundingBox<dim> &whole)
        : shape(placed)
        , placement(its_placement)
        , domain(whole)
      {}

      double
      distance(const Point<dim> &x) const override
      {
        return placement.scale * shape->distance(placement.take_back(x));
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        return placement.rotation * shape->normal(placement.take_back(x));
      }

      double
      level(const Point<dim> &x) const override
      {
        return shape->level(placement.take_back(x));
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        const BoundingBox<dim> box = placement.place(shape->bounding_box());
        return is_endless() ? common_box(box, domain) : box;
      }

      bool
      is_endless() const override
      {
        return shape->is_endless();
      }

      double
      volume() const override
      {
        return is_endless() ? Shape<dim>::volume() :
                              std::pow(placement.scale, dim) * shape->volume();
      }

      bool
      bounds_distance() const override
      {
        return shape->bounds_distance();
      }

      Thickness<dim>
      least_thickness() const override
      {
        const Thickness<dim> result = shape->least_thickness();
        return {placement.scale * result.length, placement.place(result.place)};
      }

    private:
      const SharedShape<dim> shape;
      const Placement<dim>   placement;
      const BoundingBox<dim> domain;
    };
  } // namespace

  template <int dim>
  Point<dim>
  Placement<dim>::place(const Point<dim> &x) const
  {
    return pivot + rotation * (scale * x - pivot) + shift;
  }

  template <int dim>
  Point<dim>
  Placement<dim>::take_back(const Point<dim> &x) const
  {
    return (pivot + transpose(rotation) * (x - shift - pivot)) / scale;
  }

  template <int dim>
  BoundingBox<dim>
  Placement<dim>::place(const BoundingBox<dim> &box) const
  {
    return box_of_corners(box, [&](const auto &x) { return place(x); });
  }

  template <int dim>
  BoundingBox<dim>
  Placement<dim>::take_back(const BoundingBox<dim> &box) const
  {
    return box_of_corners(box, [&](const auto &x) { return take_back(x); });
  }

  template <int dim>
  ShapePointer<dim>
  placed_shape(const SharedShape<dim> &shape,
               const Placement<dim>   &placement,
               const BoundingBox<dim> &domain)
  {
    return std::make_unique<PlacedShape<dim>>(shape, placement, domain);
  }

#define INSTANTIATE(dim)                                            \
  template struct Placement<dim>;                                   \
  template ShapePointer<dim> placed_shape(const SharedShape<dim> &, \
                                          const Placement<dim> &,   \
                                          const BoundingBox<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
