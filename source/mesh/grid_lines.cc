// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/grid_lines.h>

#include <algorithm>

namespace seiche
{
  template <int dim>
  GridLines<dim>::GridLines(const BackgroundGrid<dim> &background_grid)
    : grid(background_grid)
  {
    make_lines();
  }



  template <int dim>
  void
  GridLines<dim>::make_lines()
  {
    obstacle_shift = grid.finest_level() - grid.lattice_level();
    for (unsigned int d = 0; d < dim; ++d)
      {
        start[d] = make_line(d, nullptr);
        lines[d] = motion != nullptr ? make_line(d, motion) : start[d];
      }
  }



  template <int dim>
  typename GridLines<dim>::Line
  GridLines<dim>::make_line(const unsigned int     direction,
                            const GridMotion<dim> *moving) const
  {
    const auto place_of = [&](const double x) {
      return moving != nullptr ? moving->line(direction, x, time_of_lines) : x;
    };
    Line line;
    for (const auto &segment : grid.segments(direction))
      {
        const double       begin = place_of(segment.begin);
        const double       end   = place_of(segment.end);
        const unsigned int n     = segment.cells << obstacle_shift;
        const double       size  = (end - begin) / n;
        line.segments.push_back(
          {end, begin, 1. / size, segment.first << obstacle_shift});
        for (unsigned int i = 0; i < n; ++i)
          line.places.push_back(begin + i * size);
      }
    line.places.push_back(line.segments.back().end);
    return line;
  }



  template <int dim>
  unsigned int
  GridLines<dim>::Line::index(const double x) const
  {
    unsigned int s = 0;
    while (s + 1 < segments.size() && x >= segments[s].end)
      ++s;
    const Segment &segment = segments[s];
    unsigned int   i =
      segment.first +
      static_cast<unsigned int>((x - segment.begin) * segment.inverse_size);
    // the quotient is off by round-off; the lines decide
    i = std::min<unsigned int>(i, places.size() - 2);
    if (x < places[i])
      --i;
    else if (x >= places[i + 1] && i + 2 < places.size())
      ++i;
    return i;
  }



  template <int dim>
  void
  GridLines<dim>::move(const GridMotion<dim> &grid_motion, const double time)
  {
    motion        = &grid_motion;
    time_of_lines = time;
    make_lines();
  }



  template <int dim>
  dealii::Point<dim>
  GridLines<dim>::moved(const dealii::Point<dim> &x) const
  {
    dealii::Point<dim> result = x;
    if (motion != nullptr)
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = motion->line(d, x[d], time_of_lines);
    return result;
  }



  template <int dim>
  dealii::BoundingBox<dim>
  GridLines<dim>::domain() const
  {
    dealii::Point<dim> lower, upper;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] = front(d);
        upper[d] = back(d);
      }
    return dealii::BoundingBox<dim>({lower, upper});
  }



  template <int dim>
  CellGeometry<dim>
  GridLines<dim>::box(const Index &lower, const Index &upper) const
  {
    dealii::Point<dim> low, high;
    for (unsigned int d = 0; d < dim; ++d)
      {
        low[d]  = place(d, lower[d]);
        high[d] = place(d, upper[d]);
      }
    return {low, high};
  }



  template <int dim>
  bool
  GridLines<dim>::in_obstacle(const Index &index) const
  {
    for (unsigned int i = 0; i < grid.parameters.obstacles().size(); ++i)
      {
        const auto &box    = grid.obstacle_box(i);
        bool        inside = true;
        for (unsigned int d = 0; d < dim; ++d)
          inside &= (index[d] >> obstacle_shift) >= box.first[d] &&
                    (index[d] >> obstacle_shift) < box.second[d];
        if (inside)
          return true;
      }
    return false;
  }



  template class GridLines<2>;
  template class GridLines<3>;
} // namespace seiche
