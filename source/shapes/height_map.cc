// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/height_map.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Between which places something lies: the lower one, its share of the way
    /// to the next, and the slope of that [1/m].
    struct Interval
    {
      std::size_t lower;
      double      share, slope;
    };

    Interval
    find(const std::vector<double> &places, const double x)
    {
      const auto next =
        std::upper_bound(places.begin() + 1, places.end() - 1, x);
      const std::size_t lower  = next - places.begin() - 1;
      const double      length = places[lower + 1] - places[lower];
      const double      share  = (x - places[lower]) / length;
      const bool        beyond = share < 0. || share > 1.;
      return {lower, std::clamp(share, 0., 1.), beyond ? 0. : 1. / length};
    }

    template <int dim>
    class HeightMapShape : public Shape<dim>
    {
    public:
      HeightMapShape(HeightMap<dim> &&heights, const BoundingBox<dim> &whole)
        : map(std::move(heights))
        , domain(whole)
      {}

      double
      distance(const Point<dim> &x) const override
      {
        const auto [height, slopes] = map.at(x);
        return (x[dim - 1] - height) / std::sqrt(1. + slopes.norm_square());
      }

      double
      level(const Point<dim> &x) const override
      {
        return x[dim - 1] - map.at(x).first;
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        const auto     slopes = map.at(x).second;
        Tensor<1, dim> result;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          result[d] = -slopes[d];
        result[dim - 1] = 1.;
        return result / result.norm();
      }

      bool
      is_endless() const override
      {
        return true;
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        auto         corners = domain.get_boundary_points();
        const double top =
          *std::max_element(map.heights.begin(), map.heights.end());
        corners.second[dim - 1] =
          std::clamp(top, corners.first[dim - 1], corners.second[dim - 1]);
        return BoundingBox<dim>(corners);
      }

    private:
      const HeightMap<dim>   map;
      const BoundingBox<dim> domain;
    };
  } // namespace

  template <int dim>
  std::pair<double, Tensor<1, dim - 1>>
  HeightMap<dim>::at(const Point<dim> &x) const
  {
    std::pair<double, Tensor<1, dim - 1>> result;
    std::array<Interval, dim - 1>         intervals;
    for (unsigned int d = 0; d + 1 < dim; ++d)
      intervals[d] = find(places[d], x[d]);
    for (unsigned int corner = 0; corner < (1u << (dim - 1)); ++corner)
      {
        std::array<double, dim - 1> weights, slopes;
        std::size_t                 place = 0, stride = 1;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          {
            const bool      upper    = ((corner >> d) & 1u) != 0;
            const Interval &interval = intervals[d];
            weights[d] = upper ? interval.share : 1. - interval.share;
            slopes[d]  = upper ? interval.slope : -interval.slope;
            place += (interval.lower + upper) * stride;
            stride *= places[d].size();
          }
        const double height = heights[place];
        double       weight = 1.;
        for (const double w : weights)
          weight *= w;
        result.first += weight * height;
        for (unsigned int d = 0; d + 1 < dim; ++d)
          {
            double slope = slopes[d];
            for (unsigned int e = 0; e + 1 < dim; ++e)
              if (e != d)
                slope *= weights[e];
            result.second[d] += slope * height;
          }
      }
    return result;
  }

  template <int dim>
  ShapePointer<dim>
  height_map_shape(HeightMap<dim> &&map, const BoundingBox<dim> &domain)
  {
    return std::make_unique<HeightMapShape<dim>>(std::move(map), domain);
  }

#define INSTANTIATE(dim)                                         \
  template struct HeightMap<dim>;                                \
  template ShapePointer<dim> height_map_shape(HeightMap<dim> &&, \
                                              const BoundingBox<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
