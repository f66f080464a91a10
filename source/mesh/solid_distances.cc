// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/solid_distances.h>

#include <algorithm>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    void
    lower_by(const Solid<dim>              &solid,
             const std::vector<Point<dim>> &places,
             std::vector<double>           &distances)
    {
      for (std::size_t i = 0; i < places.size(); ++i)
        distances[i] = std::min(distances[i], solid.shape->distance(places[i]));
    }
  } // namespace

  template <int dim>
  std::vector<double>
  SolidDistances<dim>::at(const std::vector<Solid<dim>> &solids,
                          const std::vector<Point<dim>> &places)
  {
    std::vector<double> result;
    if (!kept_places.empty() && kept_places == places)
      result = of_solids_at_rest;
    else
      {
        result.assign(places.size(), std::numeric_limits<double>::max());
        for (const Solid<dim> &solid : solids)
          if (solid.motion == nullptr)
            lower_by(solid, places, result);
        if (any_moves(solids))
          {
            kept_places       = places;
            of_solids_at_rest = result;
          }
      }
    for (const Solid<dim> &solid : solids)
      if (solid.motion != nullptr)
        lower_by(solid, places, result);
    return result;
  }

  template class SolidDistances<2>;
  template class SolidDistances<3>;
} // namespace seiche
