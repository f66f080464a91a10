// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/wall_slack.h>

#include <cmath>

// The part of GridParameters that knows what is where.
namespace seiche
{
  template <int dim>
  dealii::BoundingBox<dim>
  GridParameters<dim>::domain() const
  {
    return dealii::BoundingBox<dim>({lower_corner, upper_corner});
  }

  template <int dim>
  const Wall<dim> *
  GridParameters<dim>::obstacle_at(const dealii::Point<dim> &place) const
  {
    for (const Wall<dim> &obstacle : obstacles())
      if (obstacle.distance(place, /*t=*/0.) <= 0.)
        return &obstacle;
    return nullptr;
  }

  template <int dim>
  dealii::Point<dim>
  GridParameters<dim>::with_sides(const dealii::Point<dim>       &place,
                                  const dealii::BoundingBox<dim> &box) const
  {
    const auto [low, high]    = box.get_boundary_points();
    dealii::Point<dim> result = place;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double slack = wall_slack(upper_corner[d] - lower_corner[d]);
        for (const Wall<dim> &obstacle : obstacles())
          for (const double face :
               {obstacle.lower_corner[d], obstacle.upper_corner[d]})
            if (std::abs(place[d] - face) <= slack)
              result[d] = face;
        if (std::abs(place[d] - lower_corner[d]) <= slack)
          result[d] = low[d];
        else if (std::abs(place[d] - upper_corner[d]) <= slack)
          result[d] = high[d];
      }
    return result;
  }



  template dealii::BoundingBox<2>
  GridParameters<2>::domain() const;
  template dealii::BoundingBox<3>
  GridParameters<3>::domain() const;
  template const Wall<2> *
  GridParameters<2>::obstacle_at(const dealii::Point<2> &) const;
  template const Wall<3> *
  GridParameters<3>::obstacle_at(const dealii::Point<3> &) const;
  template dealii::Point<2>
  GridParameters<2>::with_sides(const dealii::Point<2> &,
                                const dealii::BoundingBox<2> &) const;
  template dealii::Point<3>
  GridParameters<3>::with_sides(const dealii::Point<3> &,
                                const dealii::BoundingBox<3> &) const;
} // namespace seiche
