// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/solid_shapes.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    class CylinderShape : public Shape<3>
    {
    public:
      CylinderShape(const Point<3> &first_end,
                    const Point<3> &last_end,
                    const double    outer_radius)
        : centre(0.5 * (first_end + last_end))
        , axis((last_end - first_end) / first_end.distance(last_end))
        , half_length(0.5 * first_end.distance(last_end))
        , radius(outer_radius)
      {}

      double
      distance(const Point<3> &x) const override
      {
        const Place place = find(x);
        if (place.beyond_end > 0. && place.beyond_mantle > 0.)
          return std::hypot(place.beyond_end, place.beyond_mantle);
        return std::max(place.beyond_end, place.beyond_mantle);
      }

      Tensor<1, 3>
      normal(const Point<3> &x) const override
      {
        const Place  place  = find(x);
        const double length = place.from_axis.norm();
        Tensor<1, 3> sideways;
        if (length > 0.)
          sideways = place.from_axis / length;
        if (place.beyond_end > 0. && place.beyond_mantle > 0.)
          return (place.beyond_end * place.along +
                  place.beyond_mantle * sideways) /
                 std::hypot(place.beyond_end, place.beyond_mantle);
        return place.beyond_end >= place.beyond_mantle || length == 0. ?
                 place.along :
                 sideways;
      }

      BoundingBox<3>
      bounding_box() const override
      {
        Tensor<1, 3> half;
        for (unsigned int d = 0; d < 3; ++d)
          half[d] = half_length * std::abs(axis[d]) +
                    radius * std::sqrt(std::max(0., 1. - axis[d] * axis[d]));
        return BoundingBox<3>({centre - half, centre + half});
      }

      double
      volume() const override
      {
        return 2. * half_length * dealii::numbers::PI * radius * radius;
      }

    private:
      struct Place
      {
        Tensor<1, 3> along, from_axis; // unit vector to the nearer end; [m]
        double       beyond_end, beyond_mantle; // [m]
      };

      Place
      find(const Point<3> &x) const
      {
        const Tensor<1, 3> way       = x - centre;
        const double       height    = way * axis;
        const Tensor<1, 3> from_axis = way - height * axis;
        return {height < 0. ? -axis : axis,
                from_axis,
                std::abs(height) - half_length,
                from_axis.norm() - radius};
      }

      const Point<3>     centre;
      const Tensor<1, 3> axis;
      const double       half_length, radius;
    };
  } // namespace

  ShapePointer<3>
  cylinder_shape(const Point<3> &first_end,
                 const Point<3> &last_end,
                 const double    radius)
  {
    return std::make_unique<CylinderShape>(first_end, last_end, radius);
  }
} // namespace seiche
