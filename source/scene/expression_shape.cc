// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/expression_shape.h>
#include <seiche/shapes/unit_vector.h>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    constexpr double difference = 1e-6; // of the domain's longest edge

    template <int dim>
    class ExpressionShape : public Shape<dim>
    {
    public:
      ExpressionShape(Expression<dim>       &&level_set,
                      const BoundingBox<dim> &whole)
        : function(std::move(level_set))
        , domain(whole)
      {
        for (unsigned int d = 0; d < dim; ++d)
          step = std::max(step, difference * domain.side_length(d));
      }

      double
      distance(const Point<dim> &x) const override
      {
        const double slope = gradient(x).norm();
        return slope > 0. ? level(x) / slope : level(x);
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        return unit_vector(gradient(x));
      }

      double
      level(const Point<dim> &x) const override
      {
        return function.value(x, /*t=*/0.);
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
      Tensor<1, dim>
      gradient(const Point<dim> &x) const
      {
        Tensor<1, dim> result;
        for (unsigned int d = 0; d < dim; ++d)
          {
            Point<dim> before = x, behind = x;
            before[d] -= step;
            behind[d] += step;
            result[d] = (level(behind) - level(before)) / (2. * step);
          }
        return result;
      }

      const Expression<dim>  function;
      const BoundingBox<dim> domain;
      double                 step = 0.; // of differences [m]
    };
  } // namespace

  template <int dim>
  ShapePointer<dim>
  expression_shape(Expression<dim> &&level, const BoundingBox<dim> &domain)
  {
    return std::make_unique<ExpressionShape<dim>>(std::move(level), domain);
  }

  template ShapePointer<2>
  expression_shape(Expression<2> &&, const BoundingBox<2> &);
  template ShapePointer<3>
  expression_shape(Expression<3> &&, const BoundingBox<3> &);
} // namespace seiche
