// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/speed_of_fall.h>
#include <seiche/utilities/exceptions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  double
  speed_of_fall(const BodyForce<dim> &force, const SceneMap<dim> &map)
  {
    double volume = 0., energy = 0.;
    struct Place
    {
      double potential, volume;
    };
    std::vector<Place> places;
    map.for_each([&](const auto &piece) {
      if (piece.content == SceneMap<dim>::obstacle)
        return;
      Tensor<1, dim> b;
      try
        {
          b = force.value(piece.centre, /*t=*/0.);
        }
      catch (const InputError &)
        {
          if (piece.content >= 0)
            throw;
          return;
        }
      const double potential = -(b * (piece.centre - Point<dim>()));
      places.push_back({potential, piece.volume});
      if (piece.content >= 0)
        {
          volume += piece.volume;
          energy += potential * piece.volume;
        }
    });
    std::sort(places.begin(), places.end(), [](const auto &a, const auto &b) {
      return a.potential < b.potential;
    });
    double left = volume;
    for (const Place &place : places)
      {
        const double filled = std::min(left, place.volume);
        energy -= filled * place.potential;
        left -= filled;
      }
    return volume > 0. ? std::sqrt(2. * std::max(energy, 0.) / volume) : 0.;
  }

  template double
  speed_of_fall(const BodyForce<2> &, const SceneMap<2> &);
  template double
  speed_of_fall(const BodyForce<3> &, const SceneMap<3> &);
} // namespace seiche
