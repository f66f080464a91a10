// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_segments.h>
#include <seiche/scene/scene_map.h>
#include <seiche/scene/wall_slack.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  namespace
  {
    /// Ascending, without those that coincide; all of [lower, upper].
    std::vector<double>
    distinct(std::vector<double> places, const double lower, const double upper)
    {
      const double tolerance = wall_slack(upper - lower);
      places.push_back(upper);
      std::sort(places.begin(), places.end());
      std::vector<double> result = {lower};
      for (const double place : places)
        if (place > result.back() + tolerance && place <= upper)
          result.push_back(place);
      result.back() = upper;
      return result;
    }



    /// Every interval cut into equal parts not longer than @p largest, at
    /// least @p fewest of them.
    std::vector<double>
    subdivided(const std::vector<double> &places,
               const double               largest,
               const double               fewest)
    {
      std::vector<double> result = {places.front()};
      for (std::size_t i = 0; i + 1 < places.size(); ++i)
        {
          const double       length = places[i + 1] - places[i];
          const unsigned int n =
            std::max(fewest, std::ceil(length / largest - 1e-6));
          for (unsigned int k = 1; k <= n; ++k)
            result.push_back(places[i] + length * k / n);
        }
      return result;
    }



    template <int dim>
    int
    content_at(const dealii::Point<dim>          &x,
               const GridParameters<dim>         &grid,
               const std::vector<FluidBody<dim>> &bodies)
    {
      for (const auto &box : grid.obstacles())
        if (box.box().point_inside(x))
          return SceneMap<dim>::obstacle;
      if (distance_from(grid.solids, x) < 0.)
        return SceneMap<dim>::obstacle;
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (bodies[b].shape->bounding_box().point_inside(x) &&
            bodies[b].shape->level(x) < 0.)
          return static_cast<int>(b);
      return SceneMap<dim>::air;
    }
  } // namespace



  template <int dim>
  SceneMap<dim>::SceneMap(const GridParameters<dim>         &grid,
                          const std::vector<FluidBody<dim>> &bodies,
                          const unsigned int                 per_direction)
  {
    make_lines(grid, bodies, per_direction);
    std::size_t n = 1;
    for (const auto &line : cuts)
      n *= line.size() - 1;
    contents.assign(n, air);
    for_each([&](const Piece &piece) {
      contents[position(piece.index)] = content_at(piece.centre, grid, bodies);
    });
  }



  template <int dim>
  void
  SceneMap<dim>::make_lines(const GridParameters<dim>         &grid,
                            const std::vector<FluidBody<dim>> &bodies,
                            const unsigned int                 per_direction)
  {
    // a body between two cuts is seen by pieces of its own size
    constexpr double fewest = (dim == 2 ? 8. : 3.);
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double lower = grid.lower_corner[d], upper = grid.upper_corner[d];
        std::vector<double> of_bodies, of_all;
        for (const auto &body : bodies)
          {
            const auto box = body.shape->bounding_box();
            of_bodies.insert(of_bodies.end(),
                             {box.lower_bound(d), box.upper_bound(d)});
          }
        of_all = of_bodies;
        for (const auto &obstacle : grid.obstacles())
          of_all.insert(of_all.end(),
                        {obstacle.lower_corner[d], obstacle.upper_corner[d]});
        for (const GridSegment &segment : make_segments(grid, d))
          of_all.push_back(segment.end);
        // without obstacles, or without anything, where there are hundreds: an
        // estimate
        for (const auto &places : {of_all, of_bodies, std::vector<double>()})
          {
            cuts[d] = distinct(places, lower, upper);
            if (cuts[d].size() <= per_direction)
              break;
          }
        const double largest = (upper - lower) / per_direction;
        cuts[d] =
          subdivided(cuts[d],
                     largest,
                     cuts[d].size() * fewest < per_direction ? fewest : 1.);
      }
  }



  template <int dim>
  std::size_t
  SceneMap<dim>::position(const Index &index) const
  {
    std::size_t result = 0;
    for (unsigned int d = dim; d-- > 0;)
      result = result * (cuts[d].size() - 1) + index[d];
    return result;
  }



  template <int dim>
  void
  SceneMap<dim>::for_each(const std::function<void(const Piece &)> &visit) const
  {
    for (std::size_t i = 0; i < contents.size(); ++i)
      {
        Piece       piece;
        std::size_t rest = i;
        piece.volume     = 1.;
        piece.content    = contents[i];
        for (unsigned int d = 0; d < dim; ++d)
          {
            const std::size_t n = cuts[d].size() - 1;
            piece.index[d]      = rest % n;
            rest /= n;
            const double begin = cuts[d][piece.index[d]],
                         end   = cuts[d][piece.index[d] + 1];
            piece.centre[d]    = 0.5 * (begin + end);
            piece.extent[d]    = end - begin;
            piece.volume *= piece.extent[d];
          }
        visit(piece);
      }
  }



  template <int dim>
  int
  SceneMap<dim>::neighbor(const Index &index, const BoxFace face) const
  {
    const unsigned int d     = face.direction();
    Index              other = index;
    if (face.is_upper() ? index[d] + 2 == cuts[d].size() : index[d] == 0)
      return obstacle;
    other[d] += face.outward();
    return contents[position(other)];
  }



  namespace
  {
    /// By @p n samples in each direction.
    template <int dim>
    SampledBody<dim>
    sample_body(const GridParameters<dim>         &grid,
                const std::vector<FluidBody<dim>> &bodies,
                const unsigned int                 body,
                const unsigned int                 n)
    {
      const auto       box       = bodies[body].shape->bounding_box();
      unsigned int     n_samples = 1, lowest = n, highest = 0;
      SampledBody<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        n_samples *= n;
      for (unsigned int i = 0; i < n_samples; ++i)
        {
          dealii::Point<dim> place; // in the unit box
          unsigned int       rest = i, layer = 0;
          for (unsigned int d = 0; d < dim; ++d, rest /= n)
            {
              layer    = rest % n; // at last the vertical one
              place[d] = (layer + 0.5) / n;
            }
          place = box.unit_to_real(place);
          if (content_at(place, grid, bodies) != static_cast<int>(body))
            continue;
          result.places.push_back(place);
          lowest  = std::min(lowest, layer);
          highest = std::max(highest, layer);
        }
      const double n_inside = static_cast<double>(result.places.size());
      const double begin    = box.lower_bound(dim - 1),
                   end      = box.upper_bound(dim - 1);
      result.resolution     = box.volume() / n_samples;
      result.is_whole       = result.places.size() == n_samples;
      result.volume =
        result.is_whole ? box.volume() : n_inside * result.resolution;
      result.ends_at_box = lowest == 0 && highest + 1 == n;
      result.bottom = lowest == 0 ? begin : begin + (end - begin) * lowest / n;
      result.top =
        highest + 1 == n ? end : begin + (end - begin) * (highest + 1) / n;
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<SampledBody<dim>>
  sample_bodies(const GridParameters<dim>         &grid,
                const std::vector<FluidBody<dim>> &bodies)
  {
    constexpr double   of_all = 65536.; // samples, of however many bodies
    const unsigned int n      = std::ceil(
      std::pow(of_all / static_cast<double>(bodies.size()), 1. / dim));
    std::vector<SampledBody<dim>> result;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      result.push_back(sample_body(grid, bodies, b, n));
    return result;
  }



  template std::vector<SampledBody<2>>
  sample_bodies(const GridParameters<2> &, const std::vector<FluidBody<2>> &);
  template std::vector<SampledBody<3>>
  sample_bodies(const GridParameters<3> &, const std::vector<FluidBody<3>> &);
  template class SceneMap<2>;
  template class SceneMap<3>;
} // namespace seiche
