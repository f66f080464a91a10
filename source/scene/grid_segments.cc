// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/scene/grid_segments.h>
#include <seiche/scene/wall_slack.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  namespace
  {
    /// Make @p place a grid line: split the segment that holds it.
    void
    insert_line(std::vector<GridSegment> &segments, const double place)
    {
      const double slack =
        wall_slack(segments.back().end - segments.front().begin);
      for (auto segment = segments.begin(); segment != segments.end();
           ++segment)
        {
          const double size = (segment->end - segment->begin) / segment->cells;
          if (place <= segment->begin + slack)
            return; // the line between two segments, or the domain's side
          if (place >= segment->end - slack)
            continue;
          GridSegment  upper  = *segment;
          const double offset = (place - segment->begin) / size;
          unsigned int cells_below =
            static_cast<unsigned int>(std::lround(offset));
          cells_below = std::max(cells_below, 1u);
          if (segment->cells > 1)
            cells_below = std::min(cells_below, segment->cells - 1);
          upper.begin    = place;
          upper.cells    = std::max(segment->cells - cells_below, 1u);
          segment->end   = place;
          segment->cells = cells_below;
          segments.insert(segment + 1, upper);
          return;
        }
    }
  } // namespace



  template <int dim>
  std::vector<GridSegment>
  make_segments(const GridParameters<dim> &parameters,
                const unsigned int         direction)
  {
    std::vector<double> places = parameters.break_points[direction];
    places.insert(places.begin(), parameters.lower_corner[direction]);
    places.push_back(parameters.upper_corner[direction]);

    std::vector<GridSegment> segments;
    for (unsigned int i = 0; i + 1 < places.size(); ++i)
      {
        const double       length = places[i + 1] - places[i];
        const unsigned int cells =
          parameters.cells[direction].empty() ?
            std::max(1L, std::lround(length / parameters.cell_size)) :
            parameters.cells[direction][i];
        segments.push_back({places[i], places[i + 1], 0, cells});
      }
    for (const auto &obstacle : parameters.obstacles())
      {
        insert_line(segments, obstacle.lower_corner[direction]);
        insert_line(segments, obstacle.upper_corner[direction]);
      }
    unsigned int first = 0;
    for (GridSegment &segment : segments)
      {
        segment.first = first;
        first += segment.cells;
      }
    return segments;
  }



  template std::vector<GridSegment>
  make_segments<2>(const GridParameters<2> &, const unsigned int);
  template std::vector<GridSegment>
  make_segments<3>(const GridParameters<3> &, const unsigned int);
} // namespace seiche
