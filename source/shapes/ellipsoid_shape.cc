// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/solid_shapes.h>
#include <seiche/shapes/unit_vector.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class EllipsoidShape : public Shape<dim>
    {
    public:
      EllipsoidShape(const Point<dim>     &middle,
                     const Tensor<1, dim> &half_lengths)
        : centre(middle)
        , semi_axes(half_lengths)
      {}

      /// r (r - 1)/|grad(r^2)/2| with r = 1 on the surface.
      double
      distance(const Point<dim> &x) const override
      {
        const double slope = half_gradient(x).norm();
        if (slope == 0.)
          return -shortest_axis();
        const double r = std::sqrt(1. + level(x));
        return r * (r - 1.) / slope;
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        return unit_vector(half_gradient(x));
      }

      double
      level(const Point<dim> &x) const override
      {
        double sum = -1.;
        for (unsigned int d = 0; d < dim; ++d)
          sum += (x[d] - centre[d]) * (x[d] - centre[d]) /
                 (semi_axes[d] * semi_axes[d]);
        return sum;
      }

      double
      volume() const override
      {
        double result =
          dim == 2 ? dealii::numbers::PI : 4. / 3. * dealii::numbers::PI;
        for (unsigned int d = 0; d < dim; ++d)
          result *= semi_axes[d];
        return result;
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        return BoundingBox<dim>({centre - semi_axes, centre + semi_axes});
      }

    private:
      Tensor<1, dim>
      half_gradient(const Point<dim> &x) const
      {
        Tensor<1, dim> result = x - centre;
        for (unsigned int d = 0; d < dim; ++d)
          result[d] /= semi_axes[d] * semi_axes[d];
        return result;
      }

      double
      shortest_axis() const
      {
        double result = semi_axes[0];
        for (unsigned int d = 1; d < dim; ++d)
          result = std::min(result, semi_axes[d]);
        return result;
      }

      const Point<dim>     centre;
      const Tensor<1, dim> semi_axes;
    };
  } // namespace

  template <int dim>
  ShapePointer<dim>
  ellipsoid_shape(const Point<dim> &centre, const Tensor<1, dim> &semi_axes)
  {
    return std::make_unique<EllipsoidShape<dim>>(centre, semi_axes);
  }

  template ShapePointer<2>
  ellipsoid_shape(const Point<2> &, const Tensor<1, 2> &);
  template ShapePointer<3>
  ellipsoid_shape(const Point<3> &, const Tensor<1, 3> &);
} // namespace seiche
