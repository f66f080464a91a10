// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/grid_evaluation.h>
#include <seiche/postprocess/place_with_walls.h>
#include <seiche/postprocess/probes.h>
#include <seiche/scene/wrapped.h>
#include <seiche/utilities/axis_names.h>
#include <seiche/utilities/over_ranks.h>
#include <seiche/utilities/result_names.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
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
          if (wall.condition != WallCondition::periodic && distance < nearest)
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

  template <int dim>
  Probes<dim>::Probes(const std::vector<Parameters>   &parameters,
                      const PostprocessorContext<dim> &context)
    : probes(parameters)
    , pressure(context.pressure)
    , table(context.file(result_names::probes), context.is_first_rank())
  {
    for (const auto &probe : probes)
      {
        places.push_back(probe.places(context.grid.parameters));
        signals.emplace_back(probe.reading_columns().size(),
                             SensorSignal(probe.sensor));
        samples.emplace_back(probe.sensor.rate > 0. ?
                               context.file(result_names::samples(probe.name)) :
                               "",
                             context.is_first_rank());
      }
  }

  template <int dim>
  std::vector<double>
  Probes<dim>::readings(const StepView<dim> &view) const
  {
    const CellLocator<dim> &locator      = view.occupancy.locator;
    const auto             &p            = pressure->field(view);
    const MPI_Comm          communicator = view.points.communicator;
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);

    // the owner of the cell around the place reads it; others add zero
    std::vector<double> result;
    for (unsigned int k = 0; k < probes.size(); ++k)
      {
        const bool          scalar = probes[k].reads_pressure();
        Tensor<1, dim>      sum;
        GridEvaluation<dim> here(view);
        for (const Point<dim> &place : places[k])
          {
            const unsigned int cell =
              locator.find(place_with_walls(view, place, 0.));
            const double theta = scalar ? view.pressure_theta : 1.;
            if (cell == CellLocator<dim>::invalid ||
                locator.cells.owner(cell) != rank ||
                !here.find(place_with_walls(view, place, theta), theta))
              continue;
            if (!scalar)
              sum += here.vector_value(view.state.velocity_np1);
            // the surface is known to a third of a cell: what is continued
            // beyond it may push, in a jet at a wall, but not pull
            else if (here.is_wet())
              sum[0] +=
                here.is_inside() ? here.value(p) : std::max(0., here.value(p));
          }
        for (unsigned int c = 0; c < (scalar ? 1 : dim); ++c)
          result.push_back(sum[c] / places[k].size());
        if (scalar && view.step == 0) // there is none before the first step
          result.back() = StatisticsTable::missing;
      }
    sum_over_ranks(result, communicator);
    return result;
  }

  template <int dim>
  void
  Probes<dim>::execute(const StepView<dim> &view, StatisticsTable &statistics)
  {
    const std::vector<double> all  = readings(view);
    auto                      next = all.begin();
    table.set("time [s]", view.time);
    table.set("pressure_time [s]", view.pressure_time);
    for (unsigned int k = 0; k < probes.size(); ++k)
      {
        const auto                columns = probes[k].reading_columns();
        const std::vector<double> values(next, next + columns.size());
        next += columns.size();
        for (unsigned int c = 0; c < columns.size(); ++c)
          {
            statistics.set(columns[c], values[c]);
            table.set(columns[c], values[c]);
          }
        record(k,
               probes[k].reads_pressure() ? view.pressure_time : view.time,
               values,
               statistics);
      }
    table.end_row();
  }

  template <int dim>
  void
  Probes<dim>::record(const unsigned int         probe,
                      const double               time,
                      const std::vector<double> &values,
                      StatisticsTable           &statistics)
  {
    const std::vector<std::string> columns = probes[probe].signal_columns();
    std::vector<std::vector<SensorSignal::Sample>> taken;
    for (unsigned int c = 0; c < columns.size(); ++c)
      {
        taken.push_back(signals[probe][c].advance(time, values[c]));
        if (probes[probe].sensor.cut_off > 0.)
          {
            statistics.set(columns[c], signals[probe][c].value());
            table.set(columns[c], signals[probe][c].value());
          }
      }
    for (std::size_t i = 0; i < taken[0].size(); ++i) // all at the same times
      {
        samples[probe].set("time [s]", taken[0][i].time);
        for (unsigned int c = 0; c < columns.size(); ++c)
          samples[probe].set(columns[c], taken[c][i].value);
        samples[probe].end_row();
      }
  }

  template <int dim>
  void
  Probes<dim>::save_or_load(StateArchive &archive)
  {
    archive.section("probes", [&]() { table.save_or_load(archive); });
    for (unsigned int k = 0; k < probes.size(); ++k)
      archive.section("probe " + probes[k].name, [&]() {
        for (unsigned int c = 0; c < signals[k].size(); ++c)
          signals[k][c].save_or_load(archive, std::to_string(c));
        samples[k].save_or_load(archive);
      });
  }

  template struct ProbeParameters<2>;
  template struct ProbeParameters<3>;
  template class Probes<2>;
  template class Probes<3>;
} // namespace seiche
