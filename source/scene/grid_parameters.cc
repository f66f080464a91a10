// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/grid_parameters.h>
#include <seiche/scene/grid_segments.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace seiche
{
  namespace
  {
    /// No scene is larger, and powers of what is far above are no numbers any
    /// more [m].
    constexpr double largest_coordinate = 1e15;

    /// Cells of the finest lattice along a direction: all of them are counted
    /// in 64 bits, those along one in 32.
    template <int dim>
    constexpr double largest_line = dim == 2 ? 2147483647. : 2097151.;

    std::string
    per_direction(const std::string &entry, const unsigned int direction)
    {
      return fmt::format("{} {}", entry, "xyz"[direction]);
    }
  } // namespace



  template <int dim>
  GridParameters<dim>::GridParameters(const InputFile &input)
    : refinement(input)
  {
    for (unsigned int side = 0; side < 2 * dim; ++side)
      {
        walls.emplace_back();
        walls.back().name   = side_name<dim>(side);
        walls.back().number = side;
      }
    for (const std::string &name : input.instances("Obstacle"))
      {
        walls.emplace_back();
        walls.back().name   = name;
        walls.back().number = walls.size() - 1;
      }
    walls_text.resize(walls.size());
  }



  template <int dim>
  void
  GridParameters<dim>::add_parameters(dealii::ParameterHandler &prm)
  {
    const dealii::Patterns::Anything anything;
    prm.enter_subsection("Grid");
    prm.add_parameter("Lower corner",
                      lower_text,
                      "Corner of the box domain with the smallest "
                      "coordinates. [m]",
                      anything,
                      /*has_to_be_set=*/true);
    prm.add_parameter("Upper corner",
                      upper_text,
                      "Corner of the box domain with the greatest "
                      "coordinates. [m]",
                      anything,
                      /*has_to_be_set=*/true);
    prm.add_parameter("Cell size",
                      cell_size,
                      "Wanted edge length of the cells; every segment gets "
                      "the nearest whole number of equal cells. Needed in "
                      "directions without \"Cells\". [m]",
                      dealii::Patterns::Double(0.));
    for (unsigned int d = 0; d < dim; ++d)
      {
        prm.add_parameter(per_direction("Break points", d),
                          break_points_text[d],
                          "Ascending places inside the domain that have to "
                          "be grid lines. They cut the direction into "
                          "segments of equal cells, as do the corners of "
                          "obstacles. [m]");
        prm.add_parameter(per_direction("Cells", d),
                          cells_text[d],
                          "Numbers of cells, one per segment between break "
                          "points; overrides \"Cell size\". A segment that "
                          "the corner of an obstacle cuts shares them out "
                          "in proportion. [-]");
      }
    prm.leave_subsection();

    add_side_parameters(prm);
    add_obstacle_parameters(prm);
    refinement.add_parameters(prm);
  }



  template <int dim>
  void
  GridParameters<dim>::check(const InputFile &input)
  {
    lower_corner =
      entry_values::point<dim>(input, "Grid/Lower corner", lower_text);
    upper_corner =
      entry_values::point<dim>(input, "Grid/Upper corner", upper_text);
    for (unsigned int d = 0; d < dim; ++d)
      for (const auto &[corner, path] :
           {std::make_pair(lower_corner, "Grid/Lower corner"),
            std::make_pair(upper_corner, "Grid/Upper corner")})
        input.require(std::abs(corner[d]) <= largest_coordinate,
                      path,
                      "coordinates are at most 1e15 m.");
    for (unsigned int d = 0; d < dim; ++d)
      input.require(lower_corner[d] < upper_corner[d],
                    "Grid/Upper corner",
                    "must be greater than \"Lower corner\" in every "
                    "direction.");
    for (unsigned int d = 0; d < dim; ++d)
      check_lines(input, d);
    input.read_only_if(std::any_of(cells.begin(),
                                   cells.end(),
                                   [](const auto &of_segments) {
                                     return of_segments.empty();
                                   }),
                       "Grid/Cell size",
                       "a direction without \"Cells\"");
    check_walls(input);
    check_size(input);
    refinement.check(input, *this);
  }



  template <int dim>
  void
  GridParameters<dim>::check_lines(const InputFile   &input,
                                   const unsigned int direction)
  {
    const std::string breaks_path =
      "Grid/" + per_direction("Break points", direction);
    const std::string cells_path = "Grid/" + per_direction("Cells", direction);

    break_points[direction] =
      entry_values::numbers(input, breaks_path, break_points_text[direction]);
    double last = lower_corner[direction];
    for (const double place : break_points[direction])
      {
        input.require(place > last && place < upper_corner[direction],
                      breaks_path,
                      fmt::format("{:g} m is not between {:g} and {:g} m; "
                                  "break points have to ascend and to lie "
                                  "inside the domain.",
                                  place,
                                  last,
                                  upper_corner[direction]));
        last = place;
      }

    cells[direction] =
      entry_values::counts(input, cells_path, cells_text[direction]);
    const unsigned int n_segments = break_points[direction].size() + 1;
    if (cells[direction].empty())
      input.require(cell_size > 0.,
                    "Grid/Cell size",
                    "must be greater than zero [m], or give the numbers of "
                    "cells by \"" +
                      per_direction("Cells", direction) + "\".");
    else
      input.require(cells[direction].size() == n_segments,
                    cells_path,
                    fmt::format("{} number(s) given; {} needed, one for "
                                "each segment between break points.",
                                cells[direction].size(),
                                n_segments));
  }



  template <int dim>
  void
  GridParameters<dim>::check_size(const InputFile &input) const
  {
    const auto entry = [this](const unsigned int direction) {
      return cells[direction].empty() ?
               "Grid/Cell size" :
               "Grid/" + per_direction("Cells", direction);
    };
    const unsigned int level  = refinement.finest_level();
    double             n_rows = dim;
    for (unsigned int d = 0; d < dim; ++d)
      {
        // the lattice is stored as unsigned int, so test before it is made
        double n_cells = 0.;
        for (const unsigned int n : cells[d])
          n_cells += n;
        if (cells[d].empty())
          n_cells = (upper_corner[d] - lower_corner[d]) / cell_size;
        n_rows *= n_cells + 1.;
        const double n_finest = std::ldexp(n_cells, level);
        input.require(n_finest < largest_line<dim>,
                      entry(d),
                      fmt::format("makes {:.3g} cells of the finest level ({}) "
                                  "in direction {}; at most {:.3g} are "
                                  "possible. Choose larger cells or smaller "
                                  "levels of refinement.",
                                  n_finest,
                                  level,
                                  "xyz"[d],
                                  largest_line<dim>));
      }
    check_thin_cells(input);
    input.require(n_rows <= std::numeric_limits<int>::max(),
                  entry(0),
                  fmt::format("makes {:.3g} rows in the velocity block; at "
                              "most 2^31 - 1 are possible. Choose larger "
                              "cells.",
                              n_rows));
  }



  template <int dim>
  void
  GridParameters<dim>::check_thin_cells(const InputFile &input) const
  {
    // beside a cell so thin a step is as short as it takes to cross it; mostly
    // a break point or a corner of an obstacle that misses another by rounding
    constexpr double thinnest = 0.01;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const auto segments = make_segments(*this, d);
        const auto size     = [](const GridSegment &segment) {
          return (segment.end - segment.begin) / segment.cells;
        };
        const auto [thin, wide] =
          std::minmax_element(segments.begin(),
                              segments.end(),
                              [&](const auto &a, const auto &b) {
                                return size(a) < size(b);
                              });
        input.require(size(*thin) > thinnest * size(*wide),
                      per_direction("Grid/Break points", d),
                      fmt::format("cells of {:.3g} m between {:.10g} and "
                                  "{:.10g} m in direction {} and of {:.3g} m "
                                  "elsewhere; at least {:g} of it is needed. "
                                  "Move the break point or the corner of an "
                                  "obstacle there.",
                                  size(*thin),
                                  thin->begin,
                                  thin->end,
                                  "xyz"[d],
                                  size(*wide),
                                  thinnest));
      }
  }



  template struct GridParameters<2>;
  template struct GridParameters<3>;
} // namespace seiche
