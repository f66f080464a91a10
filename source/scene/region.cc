// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/region.h>

#include <algorithm>

namespace seiche
{
  namespace
  {
    template <int dim>
    using Box = dealii::BoundingBox<dim>;



    template <int dim>
    class BoxRegion : public Region<dim>
    {
    public:
      explicit BoxRegion(const Box<dim> &extent)
        : box(extent)
      {}

      double
      level(const dealii::Point<dim> &x) const override
      {
        double result = std::numeric_limits<double>::lowest();
        for (unsigned int d = 0; d < dim; ++d)
          result = std::max(
            {result, box.lower_bound(d) - x[d], x[d] - box.upper_bound(d)});
        return result;
      }

      bool
      is_box() const override
      {
        return true;
      }

      double
      volume() const override
      {
        return box.volume();
      }

      Box<dim>
      bounding_box() const override
      {
        return box;
      }

      Box<dim>
      lattice_box(const Box<dim> &cell) const override
      {
        auto corners = cell.get_boundary_points();
        for (unsigned int d = 0; d < dim; ++d)
          {
            corners.first[d]  = std::max(corners.first[d], box.lower_bound(d));
            corners.second[d] = std::min(corners.second[d], box.upper_bound(d));
            corners.second[d] = std::max(corners.second[d], corners.first[d]);
          }
        return Box<dim>(corners);
      }

    private:
      const Box<dim> box;
    };



    template <int dim>
    class EllipsoidRegion : public Region<dim>
    {
    public:
      EllipsoidRegion(const dealii::Point<dim>     &middle,
                      const dealii::Tensor<1, dim> &half_lengths)
        : centre(middle)
        , semi_axes(half_lengths)
      {}

      double
      level(const dealii::Point<dim> &x) const override
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
        double result = dim == 2 ? M_PI : 4. / 3. * M_PI;
        for (unsigned int d = 0; d < dim; ++d)
          result *= semi_axes[d];
        return result;
      }

      Box<dim>
      bounding_box() const override
      {
        return Box<dim>({centre - semi_axes, centre + semi_axes});
      }

    private:
      const dealii::Point<dim>     centre;
      const dealii::Tensor<1, dim> semi_axes;
    };



    template <int dim>
    class ExpressionRegion : public Region<dim>
    {
    public:
      ExpressionRegion(Expression<dim> &&level_set, const Box<dim> &whole)
        : function(std::move(level_set))
        , domain(whole)
      {}

      double
      level(const dealii::Point<dim> &x) const override
      {
        return function.value(x, /*t=*/0.);
      }

      Box<dim>
      bounding_box() const override
      {
        return domain;
      }

    private:
      const Expression<dim> function;
      const Box<dim>        domain;
    };
  } // namespace



  template <int dim>
  Box<dim>
  Region<dim>::lattice_box(const Box<dim> &cell) const
  {
    return cell;
  }



  template <int dim>
  std::unique_ptr<Region<dim>>
  box_region(const Box<dim> &box)
  {
    return std::make_unique<BoxRegion<dim>>(box);
  }



  template <int dim>
  std::unique_ptr<Region<dim>>
  ellipsoid_region(const dealii::Point<dim>     &centre,
                   const dealii::Tensor<1, dim> &semi_axes)
  {
    return std::make_unique<EllipsoidRegion<dim>>(centre, semi_axes);
  }



  template <int dim>
  std::unique_ptr<Region<dim>>
  expression_region(Expression<dim> &&level_set, const Box<dim> &domain)
  {
    return std::make_unique<ExpressionRegion<dim>>(std::move(level_set),
                                                   domain);
  }



#define INSTANTIATE(dim)                                                   \
  template class Region<dim>;                                              \
  template std::unique_ptr<Region<dim>> box_region<dim>(const Box<dim> &); \
  template std::unique_ptr<Region<dim>> ellipsoid_region<dim>(             \
    const dealii::Point<dim> &, const dealii::Tensor<1, dim> &);           \
  template std::unique_ptr<Region<dim>> expression_region<dim>(            \
    Expression<dim> &&, const Box<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
