// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/grid_evaluation.h>
#include <seiche/postprocess/place_with_walls.h>
#include <seiche/postprocess/probes.h>
#include <seiche/utilities/over_ranks.h>
#include <seiche/utilities/result_names.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

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

  template class Probes<2>;
  template class Probes<3>;
} // namespace seiche
