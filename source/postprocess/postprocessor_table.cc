// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/alarms.h>
#include <seiche/postprocess/error_norms.h>
#include <seiche/postprocess/front_position.h>
#include <seiche/postprocess/grid_output.h>
#include <seiche/postprocess/mass_and_energy.h>
#include <seiche/postprocess/mean_level.h>
#include <seiche/postprocess/output_parameters.h>
#include <seiche/postprocess/paraview_state.h>
#include <seiche/postprocess/point_output.h>
#include <seiche/postprocess/point_series.h>
#include <seiche/postprocess/postprocessor_table.h>
#include <seiche/postprocess/probes.h>
#include <seiche/postprocess/run_up.h>
#include <seiche/postprocess/scores.h>
#include <seiche/postprocess/surface_output.h>
#include <seiche/postprocess/tracked_points.h>
#include <seiche/postprocess/verdicts.h>
#include <seiche/postprocess/wall_forces.h>
#include <seiche/postprocess/walls_output.h>
#include <seiche/postprocess/water_level.h>
#include <seiche/scene/entry_values.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  namespace
  {
    /// The subsections "KIND NAME" of the file, in its order.
    template <typename Parameters>
    std::vector<Parameters>
    find_instances(const InputFile &input)
    {
      std::vector<Parameters> result;
      for (const std::string &name : input.instances(Parameters::kind))
        {
          result.emplace_back();
          result.back().name = name;
        }
      return result;
    }

    template <typename Parameters>
    void
    declare(std::vector<Parameters> &instances, ParameterHandler &prm)
    {
      for (Parameters &instance : instances)
        {
          prm.enter_subsection(std::string(Parameters::kind) + " " +
                               instance.name);
          instance.add_parameters(prm);
          prm.leave_subsection();
        }
    }

    /// Check the instances and note the columns that they will add.
    template <typename Parameters, int dim>
    void
    check_instances(const std::vector<Parameters> &instances,
                    const InputFile               &input,
                    const GridParameters<dim>     &grid,
                    std::vector<std::string>      &columns)
    {
      for (const Parameters &instance : instances)
        {
          instance.check(input, grid);
          for (const std::string &column : instance.columns())
            {
              if (std::find(columns.begin(), columns.end(), column) !=
                  columns.end())
                throw InputError(input.filename + ": subsection \"" +
                                 Parameters::kind + " " + instance.name +
                                 "\": there is a column \"" + column +
                                 "\" already; choose another name.");
              columns.push_back(column);
            }
        }
    }
  } // namespace

  template <int dim>
  struct PostprocessorList<dim>::Implementation
  {
    explicit Implementation(const InputFile &input_file)
      : input(input_file)
      , fronts(find_instances<FrontParameters<dim>>(input_file))
      , gauges(find_instances<GaugeParameters<dim>>(input_file))
      , run_ups(find_instances<RunUpParameters<dim>>(input_file))
      , probes(find_instances<ProbeParameters<dim>>(input_file))
      , tracks(find_instances<TrackedPointParameters<dim>>(input_file))
      , forces(find_instances<ForceParameters<dim>>(input_file))
      , errors(find_instances<ErrorParameters<dim>>(input_file))
      , score_parameters(find_instances<ScoreParameters>(input_file))
      , verdicts(find_instances<VerdictParameters>(input_file))
    {}

    /// Output objects; nothing is made without an interval.
    void
    make_frames(const std::string         &directory,
                const BackgroundGrid<dim> &grid,
                const MPI_Comm             communicator);

    const InputFile &input;

    OutputParameters                         output;
    std::vector<FrontParameters<dim>>        fronts;
    std::vector<GaugeParameters<dim>>        gauges;
    std::vector<RunUpParameters<dim>>        run_ups;
    std::vector<ProbeParameters<dim>>        probes;
    std::vector<TrackedPointParameters<dim>> tracks;
    std::vector<ForceParameters<dim>>        forces;
    std::vector<ErrorParameters<dim>>        errors;
    std::vector<ScoreParameters>             score_parameters;
    std::vector<VerdictParameters>           verdicts;

    std::shared_ptr<NodalPressure<dim>>              pressure;
    std::shared_ptr<FluidExtentOfStep<dim>>          extent;
    std::vector<std::unique_ptr<Postprocessor<dim>>> list;
    const MassAndEnergy<dim>                        *ledger = nullptr;
    const Alarms<dim>                               *alarms = nullptr;
    std::vector<Score>                               scores;
    bool                                             rejects = false;
  };

  template <int dim>
  void
  PostprocessorList<dim>::Implementation::make_frames(
    const std::string         &directory,
    const BackgroundGrid<dim> &grid,
    const MPI_Comm             communicator)
  {
    if (directory.empty() || output.interval == 0.)
      return;
    const FrameSettings settings{directory,
                                 output.interval,
                                 entry_values::number(input,
                                                      "Time/End time",
                                                      input.value(
                                                        "Time/End time"))};
    if (output.grid)
      list.push_back(
        std::make_unique<GridOutput<dim>>(settings, pressure, communicator));
    if (output.points)
      list.push_back(
        std::make_unique<PointOutput<dim>>(settings, communicator));
    if (output.surface)
      list.push_back(
        std::make_unique<SurfaceOutput<dim>>(settings, communicator));
    if (output.series)
      list.push_back(
        std::make_unique<PointSeries<dim>>(settings, communicator));
    list.push_back(
      std::make_unique<WallsOutput<dim>>(settings, grid, communicator));
    list.push_back(
      std::make_unique<ParaViewState<dim>>(directory, communicator));
  }

  template <int dim>
  PostprocessorList<dim>::PostprocessorList(const InputFile &input)
    : implementation(std::make_unique<Implementation>(input))
  {}

  template <int dim>
  PostprocessorList<dim>::~PostprocessorList() = default;

  template <int dim>
  void
  PostprocessorList<dim>::add_parameters(ParameterHandler &prm)
  {
    implementation->output.add_parameters(prm);
    declare(implementation->fronts, prm);
    declare(implementation->gauges, prm);
    declare(implementation->run_ups, prm);
    declare(implementation->probes, prm);
    declare(implementation->tracks, prm);
    declare(implementation->forces, prm);
    declare(implementation->errors, prm);
    declare(implementation->score_parameters, prm);
    declare(implementation->verdicts, prm);
  }

  template <int dim>
  void
  PostprocessorList<dim>::check(const GridParameters<dim>      &grid,
                                const double                    end_time,
                                const std::vector<std::string> &other_columns,
                                const std::vector<std::string> &other_numbers,
                                const bool tank_moves) const
  {
    Implementation          &all     = *implementation;
    std::vector<std::string> columns = other_columns;
    for (const std::string &column : MassAndEnergy<dim>::columns())
      columns.push_back(column);
    if (tank_moves)
      for (const std::string &column : TankRecord<dim>::columns())
        columns.push_back(column);
    if (all.output.mean_level)
      columns.emplace_back(MeanLevel<dim>::column);
    check_instances(all.fronts, all.input, grid, columns);
    check_instances(all.gauges, all.input, grid, columns);
    check_instances(all.run_ups, all.input, grid, columns);
    check_instances(all.probes, all.input, grid, columns);
    check_instances(all.tracks, all.input, grid, columns);
    check_instances(all.forces, all.input, grid, columns);
    check_instances(all.errors, all.input, grid, columns);
    std::vector<std::string> numbers = other_numbers;
    const auto add = [&numbers](const std::vector<std::string> &names) {
      numbers.insert(numbers.end(), names.begin(), names.end());
    };
    add(MassAndEnergy<dim>::summary_numbers());
    if (tank_moves)
      add(TankRecord<dim>::summary_numbers());
    add(Alarms<dim>::summary_numbers());
    for (const ScoreParameters &score : all.score_parameters)
      {
        score.check(all.input, columns, end_time);
        add({VerdictParameters::of_scores + score.name});
      }
    for (VerdictParameters &verdict : all.verdicts)
      verdict.check(all.input, numbers);
    all.input.read_only_if(!all.verdicts.empty(),
                           "Output/Exit code by verdict",
                           "a Verdict NAME");
  }

  template <int dim>
  void
  PostprocessorList<dim>::make(const std::string         &directory,
                               const BackgroundGrid<dim> &grid,
                               const MPI_Comm             communicator,
                               const bool                 tank_moves)
  {
    Implementation &all = *implementation;
    all.list.clear();
    all.scores.clear();
    all.pressure = std::make_shared<NodalPressure<dim>>();
    all.extent   = std::make_shared<FluidExtentOfStep<dim>>();

    std::unique_ptr<TankRecord<dim>> tank;
    if (tank_moves)
      tank = std::make_unique<TankRecord<dim>>();
    auto ledger = std::make_unique<MassAndEnergy<dim>>(grid, tank.get());
    all.ledger  = ledger.get();
    if (tank)
      all.list.push_back(std::move(tank));
    all.list.push_back(std::move(ledger));
    auto alarms = std::make_unique<Alarms<dim>>(*all.ledger);
    all.alarms  = alarms.get();
    all.list.push_back(std::move(alarms));

    // THE table of postprocessors: one line a kind
    if (!all.fronts.empty())
      all.list.push_back(
        std::make_unique<FrontPosition<dim>>(all.fronts, grid, all.extent));
    if (!all.gauges.empty())
      all.list.push_back(
        std::make_unique<WaterLevel<dim>>(all.gauges, grid, all.extent));
    if (!all.run_ups.empty())
      all.list.push_back(
        std::make_unique<RunUp<dim>>(all.run_ups, grid, all.extent));
    if (all.output.mean_level)
      all.list.push_back(std::make_unique<MeanLevel<dim>>(all.extent));
    if (!all.probes.empty())
      all.list.push_back(std::make_unique<Probes<dim>>(
        all.probes,
        grid,
        all.pressure,
        directory,
        Utilities::MPI::this_mpi_process(communicator) == 0));
    if (!all.tracks.empty())
      all.list.push_back(std::make_unique<TrackedPoints<dim>>(all.tracks));
    if (!all.forces.empty())
      all.list.push_back(std::make_unique<WallForces<dim>>(all.forces, grid));
    for (const auto &error : all.errors)
      all.list.push_back(
        std::make_unique<ErrorNorm<dim>>(error, all.input, grid, all.pressure));
    for (const ScoreParameters &score : all.score_parameters)
      all.scores.emplace_back(score, all.input);
    all.make_frames(directory, grid, communicator);
  }

  template <int dim>
  void
  PostprocessorList<dim>::request_columns(StatisticsTable &statistics) const
  {
    for (const Score &score : implementation->scores)
      score.request(statistics);
  }

  template <int dim>
  void
  PostprocessorList<dim>::execute(const StepView<dim> &view,
                                  StatisticsTable     &statistics)
  {
    implementation->pressure->begin_step();
    implementation->extent->begin_step();
    for (const auto &postprocessor : implementation->list)
      postprocessor->execute(view, statistics);
  }

  template <int dim>
  void
  PostprocessorList<dim>::finish(const StatisticsTable  &statistics,
                                 nlohmann::ordered_json &summary)
  {
    for (const auto &postprocessor : implementation->list)
      postprocessor->finish(statistics, summary);

    // a reference into the summary would not outlive its next new entry
    nlohmann::ordered_json errors = nlohmann::ordered_json::object();
    for (const Score &score : implementation->scores)
      {
        const std::string &name = score.parameters.name;
        std::string        warning;
        const auto         value = score.evaluate(statistics, warning);
        errors[name] = value ? nlohmann::ordered_json(*value) : nullptr;
        if (!warning.empty())
          summary["warnings"].push_back((value ? "" : "no ") +
                                        std::string("score \"") + name +
                                        "\": " + warning);
      }
    summary["errors"] = errors;
    if (implementation->verdicts.empty())
      return;
    summary["verdict"]      = judge(implementation->verdicts, summary);
    implementation->rejects = implementation->output.verdict &&
                              !summary["verdict"]["passed"].get<bool>();
  }

  template <int dim>
  const OutputParameters &
  PostprocessorList<dim>::output() const
  {
    return implementation->output;
  }

  template <int dim>
  bool
  PostprocessorList<dim>::measure_forces() const
  {
    return !implementation->forces.empty();
  }

  template <int dim>
  std::vector<NamedPlace<dim>>
  PostprocessorList<dim>::places() const
  {
    std::vector<NamedPlace<dim>> result;
    for (const auto &probe : implementation->probes)
      result.push_back({probe.name, probe.position});
    for (const NamedPlace<dim> &track : tracked_places())
      result.push_back(track);
    for (const auto &gauge : implementation->gauges)
      result.push_back({gauge.name, gauge.position});
    return result;
  }

  template <int dim>
  std::vector<NamedPlace<dim>>
  PostprocessorList<dim>::tracked_places() const
  {
    std::vector<NamedPlace<dim>> result;
    for (const auto &track : implementation->tracks)
      result.push_back({track.name, track.position});
    return result;
  }

  template <int dim>
  bool
  PostprocessorList<dim>::rejects_run() const
  {
    return implementation->rejects;
  }

  template <int dim>
  void
  PostprocessorList<dim>::save_or_load(StateArchive &archive)
  {
    for (const auto &postprocessor : implementation->list)
      postprocessor->save_or_load(archive);
  }

  template <int dim>
  const std::vector<typename Alarms<dim>::Alarm> &
  PostprocessorList<dim>::raised_alarms() const
  {
    return implementation->alarms->raised();
  }

  template <int dim>
  double
  PostprocessorList<dim>::relative_energy_gain() const
  {
    return implementation->ledger->relative_energy_gain();
  }

  template <int dim>
  double
  PostprocessorList<dim>::relative_energy() const
  {
    return implementation->ledger->relative_energy();
  }

  template class PostprocessorList<2>;
  template class PostprocessorList<3>;
} // namespace seiche
