// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/shapes/composed_shapes.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    class ComposedShape : public Shape<dim>
    {
    public:
      ComposedShape(const Composition                rule,
                    std::vector<ShapePointer<dim>> &&shapes)
        : composition(rule)
        , parts(std::move(shapes))
      {}

      double
      distance(const Point<dim> &x) const override
      {
        return deciding(x).second;
      }

      Tensor<1, dim>
      normal(const Point<dim> &x) const override
      {
        const unsigned int k = deciding(x).first;
        return sign(k) * parts[k]->normal(x);
      }

      double
      level(const Point<dim> &x) const override
      {
        double result = parts[0]->level(x);
        for (unsigned int k = 1; k < parts.size(); ++k)
          {
            const double other = sign(k) * parts[k]->level(x);
            result =
              takes_least() ? std::min(result, other) : std::max(result, other);
          }
        return result;
      }

      BoundingBox<dim>
      bounding_box() const override
      {
        BoundingBox<dim> result = parts[0]->bounding_box();
        for (unsigned int k = 1; k < parts.size(); ++k)
          if (composition == Composition::sum)
            result.merge_with(parts[k]->bounding_box());
          else if (composition == Composition::intersection)
            result = common_box(result, parts[k]->bounding_box());
        return result;
      }

      bool
      is_endless() const override
      {
        const auto endless = [](const auto &part) {
          return part->is_endless();
        };
        if (composition == Composition::sum)
          return std::any_of(parts.begin(), parts.end(), endless);
        if (composition == Composition::intersection)
          return std::all_of(parts.begin(), parts.end(), endless);
        return parts[0]->is_endless();
      }

    private:
      bool
      takes_least() const
      {
        return composition == Composition::sum;
      }

      double
      sign(const unsigned int part) const
      {
        return composition == Composition::difference && part > 0 ? -1. : 1.;
      }

      /// The part whose signed distance counts, and that.
      std::pair<unsigned int, double>
      deciding(const Point<dim> &x) const
      {
        std::pair<unsigned int, double> result = {0, parts[0]->distance(x)};
        for (unsigned int k = 1; k < parts.size(); ++k)
          {
            const double other = sign(k) * parts[k]->distance(x);
            if (takes_least() ? other < result.second : other > result.second)
              result = {k, other};
          }
        return result;
      }

      const Composition                    composition;
      const std::vector<ShapePointer<dim>> parts;
    };
  } // namespace

  template <int dim>
  BoundingBox<dim>
  common_box(const BoundingBox<dim> &a, const BoundingBox<dim> &b)
  {
    auto corners = a.get_boundary_points();
    for (unsigned int d = 0; d < dim; ++d)
      {
        corners.first[d] = std::max(corners.first[d], b.lower_bound(d));
        corners.second[d] =
          std::max(corners.first[d],
                   std::min(corners.second[d], b.upper_bound(d)));
      }
    return BoundingBox<dim>(corners);
  }

  template <int dim>
  ShapePointer<dim>
  composed_shape(const Composition                composition,
                 std::vector<ShapePointer<dim>> &&parts)
  {
    Assert(!parts.empty(), ExcInternalError());
    return std::make_unique<ComposedShape<dim>>(composition, std::move(parts));
  }

#define INSTANTIATE(dim)                                           \
  template BoundingBox<dim>  common_box(const BoundingBox<dim> &,  \
                                        const BoundingBox<dim> &); \
  template ShapePointer<dim> composed_shape(                       \
    const Composition, std::vector<ShapePointer<dim>> &&);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace seiche
