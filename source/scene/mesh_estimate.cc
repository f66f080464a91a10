// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_segments.h>
#include <seiche/scene/mesh_estimate.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  namespace
  {
    /// Largest distance in any direction of a place from a box, 0 inside.
    template <int dim>
    double
    distance(const dealii::Point<dim> &x, const dealii::BoundingBox<dim> &box)
    {
      double result = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        result = std::max(
          {result, box.lower_bound(d) - x[d], x[d] - box.upper_bound(d)});
      return result;
    }



    template <int dim>
    class Estimator
    {
    public:
      using Piece = typename SceneMap<dim>::Piece;

      Estimator(const GridParameters<dim> &grid_parameters,
                const SceneMap<dim>       &scene_map)
        : grid(grid_parameters)
        , map(scene_map)
      {
        for (unsigned int d = 0; d < dim; ++d)
          segments[d] = make_segments(grid, d);
      }

      void
      add(const Piece &piece)
      {
        if (piece.content == SceneMap<dim>::obstacle)
          return;
        const bool                   is_fluid = piece.content >= 0;
        const dealii::Tensor<1, dim> edges    = edges_at(piece.centre);
        double                       n        = piece.volume; // of level 0
        for (unsigned int d = 0; d < dim; ++d)
          n /= edges[d];
        const double cells = n * of_level(level(piece, edges));
        result.cells += cells;
        if (!is_fluid)
          return;
        result.occupied += cells;
        result.full += n * of_level(grid.refinement.finest_level());
        for (const BoxFace face : dealii::GeometryInfo<dim>::face_indices())
          if (map.neighbor(piece.index, face) == SceneMap<dim>::air)
            add_surface(n * edges[face.direction()] /
                        piece.extent[face.direction()]);
      }

      MeshEstimate result;

    private:
      /// Cells of a level in one of level 0.
      static double
      of_level(const int level)
      {
        return std::ldexp(1., dim * level);
      }

      /// Of the cells of level 0 there.
      dealii::Tensor<1, dim>
      edges_at(const dealii::Point<dim> &x) const
      {
        dealii::Tensor<1, dim> edges;
        for (unsigned int d = 0; d < dim; ++d)
          {
            auto segment = segments[d].begin();
            while (segment + 1 != segments[d].end() && x[d] > segment->end)
              ++segment;
            edges[d] = (segment->end - segment->begin) / segment->cells;
          }
        return edges;
      }

      /// What the criteria ask for, but for layers around the fluid; one level
      /// coarser than the grid's lines where there is none.
      int
      level(const Piece &piece, const dealii::Tensor<1, dim> &edges) const
      {
        if (!grid.refinement.is_adaptive())
          return 0;
        const bool is_fluid = piece.content >= 0;
        int        wanted   = -1;
        for (const auto &criterion : grid.refinement.criteria)
          {
            bool claims = is_fluid && criterion.kind == RefinementKind::fluid;
            if (!criterion.follows_fluid() &&
                (is_fluid || criterion.kind == RefinementKind::box))
              for (const auto &place : criterion.places)
                claims = claims || distance(piece.centre, place) <=
                                     criterion.distance + 0.5 * edges.norm();
            if (claims)
              wanted = std::max<int>(wanted, criterion.level);
          }
        return wanted;
      }

      /// @p n: cells of level 0 beside a piece of the free surface.
      void
      add_surface(const double n)
      {
        const int finest = grid.refinement.free_surface_level();
        result.surface += n * of_level(finest) / std::ldexp(1., finest);
        for (const auto &criterion : grid.refinement.criteria)
          if (criterion.follows_fluid())
            {
              const double layer =
                n * of_level(criterion.level) / std::ldexp(1., criterion.level);
              result.cells += layer * criterion.layers;
              if (criterion.kind != RefinementKind::free_surface)
                continue;
              result.cells += layer * (criterion.layers + 1);
              result.occupied += layer * (criterion.layers + 1);
            }
      }

      const GridParameters<dim>                &grid;
      const SceneMap<dim>                      &map;
      std::array<std::vector<GridSegment>, dim> segments;
    };
  } // namespace



  template <int dim>
  MeshEstimate
  estimate_mesh(const GridParameters<dim> &grid, const SceneMap<dim> &map)
  {
    Estimator<dim> estimator(grid, map);
    map.for_each([&](const auto &piece) { estimator.add(piece); });
    MeshEstimate result = estimator.result;
    // cells that the surface cuts: it moves, and the fluid spreads
    constexpr double beside_surface = 0.75;
    result.occupied += beside_surface * result.surface;
    return result;
  }



  template MeshEstimate
  estimate_mesh<2>(const GridParameters<2> &, const SceneMap<2> &);
  template MeshEstimate
  estimate_mesh<3>(const GridParameters<3> &, const SceneMap<3> &);
} // namespace seiche
