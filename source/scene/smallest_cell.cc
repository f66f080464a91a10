// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_segments.h>
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
      for (const auto &obstacle : grid.obstacles())
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
    /// Of equal ones the first, whatever rounding says.
    void
    keep_smaller(SmallestCell &smallest, const SmallestCell &other)
    {
      if (smallest.edge == 0. || other.edge < (1. - 1e-9) * smallest.edge)
        smallest = other;
    }
  } // namespace



  template <int dim>
  SmallestCell
  smallest_edge(const GridParameters<dim> &grid, const unsigned int direction)
  {
    SmallestCell result;
    for (const GridSegment &segment : make_segments(grid, direction))
      {
        const double edge =
          std::ldexp((segment.end - segment.begin) / segment.cells,
                     -static_cast<int>(grid.refinement.finest_level()));
        keep_smaller(result, {edge, direction, segment.begin, segment.end, ""});
      }
    return result;
  }



  template <int dim>
  SmallestCell
  smallest_cell(const GridParameters<dim> &grid)
  {
    SmallestCell result = smallest_edge(grid, 0);
    for (unsigned int d = 1; d < dim; ++d)
      keep_smaller(result, smallest_edge(grid, d));
    result.cause = cause_of(grid, result);
    return result;
  }



  template SmallestCell
  smallest_edge<2>(const GridParameters<2> &, const unsigned int);
  template SmallestCell
  smallest_edge<3>(const GridParameters<3> &, const unsigned int);
  template SmallestCell
  smallest_cell<2>(const GridParameters<2> &);
  template SmallestCell
  smallest_cell<3>(const GridParameters<3> &);
} // namespace seiche
