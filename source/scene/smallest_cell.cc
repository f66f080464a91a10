// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/background_grid.h>
#include <seiche/scene/smallest_cell.h>
#include <seiche/scene/wall_slack.h>

#include <cmath>

namespace seiche
{
  namespace
  {
    /// The obstacle's corner that made a grid line, or nothing.
    template <int dim>
    std::string
    corner_at(const GridParameters<dim> &grid,
              const unsigned int         direction,
              const double               place)
    {
      const double tolerance = wall_slack(grid.domain().side_length(direction));
      for (const auto &obstacle : grid.obstacles)
        for (const bool is_lower : {true, false})
          {
            const double corner = (is_lower ? obstacle.lower_corner :
                                              obstacle.upper_corner)[direction];
            if (std::abs(corner - place) <= tolerance)
              return "Obstacle " + obstacle.name +
                     (is_lower ? "/Lower corner" : "/Upper corner");
          }
      return "";
    }



    template <int dim>
    std::string
    cause_of(const GridParameters<dim> &grid, const SmallestCell &cell)
    {
      std::string axis(1, "xyz"[cell.direction]);
      std::string result = grid.cells[cell.direction].empty() ?
                             "Grid/Cell size" :
                             "Grid/Cells " + axis;
      for (const double place : {cell.begin, cell.end})
        {
          const std::string corner = corner_at(grid, cell.direction, place);
          if (!corner.empty() && result.find(corner) == std::string::npos)
            result += ", " + corner;
        }
      const unsigned int finest = grid.refinement.finest_level();
      for (const auto &criterion : grid.refinement.criteria)
        if (finest > 0 && criterion.level == finest)
          result += ", Refinement " + criterion.name + "/Level";
      return result;
    }
  } // namespace



  template <int dim>
  SmallestCell
  smallest_cell(const GridParameters<dim> &grid)
  {
    SmallestCell result;
    for (unsigned int d = 0; d < dim; ++d)
      for (const GridSegment &segment : make_segments(grid, d))
        {
          const double edge =
            std::ldexp((segment.end - segment.begin) / segment.cells,
                       -static_cast<int>(grid.refinement.finest_level()));
          // of equal ones the first, whatever rounding says
          if (result.edge == 0. || edge < (1. - 1e-9) * result.edge)
            {
              result.edge      = edge;
              result.direction = d;
              result.begin     = segment.begin;
              result.end       = segment.end;
            }
        }
    result.cause = cause_of(grid, result);
    return result;
  }



  template SmallestCell
  smallest_cell<2>(const GridParameters<2> &);
  template SmallestCell
  smallest_cell<3>(const GridParameters<3> &);
} // namespace seiche
