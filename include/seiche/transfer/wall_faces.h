// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_wall_faces_h
#define seiche_transfer_wall_faces_h

#include <seiche/mesh/wall_tolerance.h>
#include <seiche/space/occupancy.h>

#include <algorithm>
#include <array>
#include <limits>

namespace seiche
{
  /// Faces of a cell on walls that nothing may cross, and where a step takes
  /// them.
  template <int dim, int degree>
  class WallFaces
  {
  public:
    explicit WallFaces(const Occupancy<dim> &grid_occupancy)
      : occupancy(grid_occupancy)
    {}

    void
    reinit(const unsigned int cell,
           const double (&u)[dim][Basis<dim, degree>::n_nodes])
    {
      const auto      &locator  = occupancy.locator;
      const auto       nodes    = occupancy.template unknowns<degree>(cell);
      constexpr double infinite = std::numeric_limits<double>::max();
      const auto      &geometry = locator.cells.geometry(cell);
      for (unsigned int d = 0; d < dim; ++d)
        {
          inverse[d] = 1. / geometry.edges[d];
          lower[d]   = -infinite;
          upper[d]   = infinite;
          for (unsigned int side = 0; side < 2; ++side)
            {
              const Wall<dim> *const wall =
                locator.cells.closed_wall_at(cell, BoxFace(d, side));
              // points that cross a unilateral wall are set on it
              if (wall == nullptr ||
                  wall->condition == WallCondition::unilateral)
                continue;
              // where nodes differ (hanging ones, contacts) the farthest counts
              const auto &constraints = occupancy.constraints;
              double      way         = -infinite;
              for (unsigned int a = 0; a < nodes.n_nodes; ++a)
                if (Basis<dim, degree>::line_index(a, d) == side * degree)
                  {
                    const double outwards = side == 0 ? -u[d][a] : u[d][a];
                    if (((constraints.fixed_components(nodes[a]) >> d) & 1u) ||
                        nodes.is_zero(d, a))
                      way = std::max(way, outwards);
                  }
              if (way == -infinite)
                continue;
              if (side == 0)
                lower[d] = geometry.lower[d] - way;
              else
                upper[d] = geometry.upper[d] + way;
            }
        }
    }

    /// Cells that coordinate @p x of direction d is behind a wall; 0: it is
    /// not.
    double
    way_beyond(const unsigned int d, const double x) const
    {
      return std::max(
        {0., (lower[d] - x) * inverse[d], (x - upper[d]) * inverse[d]});
    }

  private:
    const Occupancy<dim>   &occupancy;
    std::array<double, dim> lower, upper, inverse;
  };
} // namespace seiche

#endif
