// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/probe_parameters.h>
#include <seiche/scene/wrapped.h>
#include <seiche/utilities/axis_names.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// Normal direction of the wall nearest to @p x, outer sides and faces of
    /// obstacles.
    template <int dim>
    unsigned int
    wall_normal(const Point<dim> &x, const GridParameters<dim> &grid)
    {
      double         nearest = std::numeric_limits<double>::max();
      Tensor<1, dim> normal;
      for (const Wall<dim> &wall : grid.walls)
        {
          const double distance = std::abs(wall.distance(x, /*t=*/0.));
          if (wall.is_closed() && distance < nearest)
            {
              nearest = distance;
              normal  = wall.normal(x, /*t=*/0.);
            }
        }
      unsigned int result = 0;
      for (unsigned int d = 1; d < dim; ++d)
        if (std::abs(normal[d]) > std::abs(normal[result]))
          result = d;
      return result;
    }

    template <int dim>
    bool
    holds_fluid(const Point<dim> &x, const GridParameters<dim> &grid)
    {
      // on a wall is exactly there
      const Point<dim> there = grid.with_sides(x, grid.domain());
      return std::all_of(grid.walls.begin(),
                         grid.walls.end(),
                         [&](const auto &wall) {
                           return wall.distance(there, /*t=*/0.) >= 0.;
                         });
    }

    /// What lies beyond a periodic side is at the opposite one.
    template <int dim>
    Point<dim>
    across_seams(Point<dim> x, const GridParameters<dim> &grid)
    {
      for (unsigned int d = 0; d < dim; ++d)
        if (grid.is_periodic(d))
          x[d] = wrapped(x[d], grid.lower_corner[d], grid.upper_corner[d]);
      return x;
    }
  } // namespace

  template <int dim>
  void
  ProbeParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Position",
                      position,
                      "Place of the probe, in the fluid or on a wall; with a "
                      "side that moves it goes. [m]",
                      *Patterns::Tools::Convert<Point<dim>>::to_pattern(),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Quantity",
                      quantity,
                      "What is read.",
                      Patterns::Selection("pressure|velocity"));
    prm.add_parameter("Diameter",
                      diameter,
                      "Diameter of a sensor over which the mean is taken, in "
                      "the plane of the nearest wall (2D: a line), also "
                      "across periodic sides; 0: a point. [m]",
                      Patterns::Double(0.));
    sensor.add_parameters(prm);
  }

  template <int dim>
  void
  ProbeParameters<dim>::check(const InputFile           &input,
                              const GridParameters<dim> &grid) const
  {
    const std::string section = std::string(kind) + " " + name;
    input.require(holds_fluid(position, grid),
                  section + "/Position",
                  "the probe lies outside the domain or inside an obstacle; "
                  "move it into the fluid or onto a wall.");
    for (const Point<dim> &x : places(grid))
      input.require(holds_fluid(x, grid),
                    section + "/Diameter",
                    "the sensor reaches beyond the wall that it lies in; "
                    "choose a smaller diameter or move it.");
    sensor.check(input, section);
  }

  template <int dim>
  std::vector<std::string>
  ProbeParameters<dim>::columns() const
  {
    std::vector<std::string> names = reading_columns();
    if (sensor.cut_off > 0.)
      for (const std::string &name : signal_columns())
        names.push_back(name);
    return names;
  }

  template <int dim>
  std::vector<std::string>
  ProbeParameters<dim>::signal_columns() const
  {
    std::vector<std::string> names = reading_columns();
    if (sensor.cut_off > 0.)
      for (std::string &column : names)
        column.insert(column.rfind(" ["), " filtered");
    return names;
  }

  template <int dim>
  std::vector<std::string>
  ProbeParameters<dim>::reading_columns() const
  {
    if (reads_pressure())
      return {"probe " + name + " pressure [Pa]"};
    std::vector<std::string> names;
    for (unsigned int d = 0; d < dim; ++d)
      names.push_back("probe " + name + " velocity " + axis_names[d] +
                      " [m/s]");
    return names;
  }

  template <int dim>
  std::vector<Point<dim>>
  ProbeParameters<dim>::places(const GridParameters<dim> &grid) const
  {
    if (diameter == 0.)
      return {position};
    const unsigned int      normal = wall_normal(position, grid);
    std::vector<Point<dim>> result;
    if constexpr (dim == 2)
      {
        constexpr unsigned int n = 9; // midpoints of equal pieces of the line
        for (unsigned int i = 0; i < n; ++i)
          {
            Point<dim> x = position;
            x[1 - normal] += diameter * ((i + 0.5) / n - 0.5);
            result.push_back(across_seams(x, grid));
          }
      }
    else
      {
        constexpr unsigned int n_rings  = 4,
                               n_angles = 8; // pieces of equal area
        for (unsigned int r = 0; r < n_rings; ++r)
          for (unsigned int a = 0; a < n_angles; ++a)
            {
              const double radius =
                0.5 * diameter * std::sqrt((r + 0.5) / n_rings);
              const double angle =
                2. * numbers::PI * (a + 0.5 * (r % 2)) / n_angles;
              Point<dim> x = position;
              x[(normal + 1) % dim] += radius * std::cos(angle);
              x[(normal + 2) % dim] += radius * std::sin(angle);
              result.push_back(across_seams(x, grid));
            }
      }
    return result;
  }

  template struct ProbeParameters<2>;
  template struct ProbeParameters<3>;
} // namespace seiche
