// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/solve/solid_stops.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Of a cell's diagonals that fluid between two walls needs to be seen, and
    /// a half that a body may still move in the step that stops it.
    constexpr double automatic = 1.5;

    template <int dim>
    double
    stop_distance(const Solid<dim> &solid, const CellGeometry<dim> &cell)
    {
      return solid.stop_distance > 0. ? solid.stop_distance :
                                        automatic * cell.edges.norm();
    }

    template <int dim>
    struct Finder
    {
      const CellLocator<dim> &locator;
      const double            time;

      std::vector<SolidNearby<dim>> found;

      /// What is near to a place of the wall of a solid in a cell.
      void
      look(const unsigned int       number,
           const Point<dim>        &x,
           const CellGeometry<dim> &cell)
      {
        const auto       &solids = locator.solids;
        const Solid<dim> &solid  = solids[number];
        for (unsigned int o = 0; o < solids.size(); ++o)
          if (o != number && (solid.is_free() || solids[o].is_free()))
            {
              const double reach =
                std::max(solid.is_free() ? stop_distance(solid, cell) : 0.,
                         solids[o].is_free() ? stop_distance(solids[o], cell) :
                                               0.);
              if (solids[o].shape->distance(x) < reach)
                found.push_back({number, o, x, solids[o].shape->normal(x)});
            }
        if (solid.is_free())
          for (const Wall<dim> &wall : locator.grid.parameters.walls)
            if (wall.is_closed() &&
                wall.distance(x, time) < stop_distance(solid, cell))
              found.push_back({number,
                               numbers::invalid_unsigned_int,
                               x,
                               wall.normal(x, time)});
      }
    };

    /// Those of all ranks.
    template <int dim>
    std::vector<SolidNearby<dim>>
    gathered(const std::vector<SolidNearby<dim>> &own,
             const MPI_Comm                       communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return own;
      constexpr unsigned int n = 2 + 2 * dim;
      std::vector<double>    packed;
      for (const SolidNearby<dim> &one : own)
        {
          packed.push_back(one.solid);
          packed.push_back(one.other);
          for (unsigned int d = 0; d < dim; ++d)
            packed.insert(packed.end(), {one.place[d], one.normal[d]});
        }
      std::vector<SolidNearby<dim>> result;
      for (const auto &part : Utilities::MPI::all_gather(communicator, packed))
        for (std::size_t i = 0; i < part.size(); i += n)
          {
            SolidNearby<dim> one;
            one.solid = static_cast<unsigned int>(part[i]);
            one.other = static_cast<unsigned int>(part[i + 1]);
            for (unsigned int d = 0; d < dim; ++d)
              {
                one.place[d]  = part[i + 2 + 2 * d];
                one.normal[d] = part[i + 3 + 2 * d];
              }
            result.push_back(one);
          }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<SolidNearby<dim>>
  solids_nearby(const Occupancy<dim> &occupancy, const double time)
  {
    const auto &locator = occupancy.locator;
    const auto &walls   = occupancy.mesh_nodes.cut_walls;
    Finder<dim> finder{locator, time, {}};
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      if (walls.cuts(cell))
        {
          const CellGeometry<dim> &geometry = locator.cells.geometry(cell);
          for (const WallPoint<dim> &point : walls.whole(cell).wall)
            finder.look(point.solid, geometry.to_real(point.unit), geometry);
        }
    auto result =
      gathered(finder.found, locator.grid.triangulation.get_communicator());
    std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
      for (unsigned int d = 0; d < dim; ++d)
        if (a.place[d] != b.place[d])
          return a.place[d] < b.place[d];
      return std::make_pair(a.solid, a.other) <
             std::make_pair(b.solid, b.other);
    });
    return result;
  }

  template std::vector<SolidNearby<2>>
  solids_nearby(const Occupancy<2> &, const double);
  template std::vector<SolidNearby<3>>
  solids_nearby(const Occupancy<3> &, const double);
} // namespace seiche
