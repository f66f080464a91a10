// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/alarms.h>
#include <seiche/postprocess/frames.h>
#include <seiche/postprocess/mass_and_energy.h>
#include <seiche/postprocess/output_parameters.h>
#include <seiche/postprocess/postprocessor_list.h>
#include <seiche/postprocess/postprocessor_table.h>
#include <seiche/postprocess/scores.h>
#include <seiche/postprocess/verdicts.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  struct PostprocessorList<dim>::Implementation
  {
    explicit Implementation(const InputFile &input_file)
      : input(input_file)
    {
      for_each_row([&](auto &row) { row.find(input); });
      score_parameters.find(input);
      verdicts.find(input);
    }

    template <typename Function>
    void
    for_each_row(const Function &function)
    {
      std::apply([&](auto &...row) { (function(row), ...); }, rows);
    }

    template <typename Made>
    const Instances<typename Made::Parameters> &
    instances() const
    {
      return std::get<BySubsections<dim, Made>>(rows).instances;
    }

    const InputFile &input;

    OutputParameters             output;
    PostprocessorTable<dim>      rows;
    Instances<ScoreParameters>   score_parameters;
    Instances<VerdictParameters> verdicts;

    std::shared_ptr<NodalPressure<dim>>     pressure;
    std::shared_ptr<FluidExtentOfStep<dim>> extent;
    Postprocessors<dim>                     list;
    const MassAndEnergy<dim>               *ledger = nullptr;
    const Alarms<dim>                      *alarms = nullptr;
    std::vector<Score>                      scores;
    bool                                    rejects = false;
  };

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
    implementation->for_each_row([&](auto &row) { row.add_parameters(prm); });
    implementation->score_parameters.add_parameters(prm);
    implementation->verdicts.add_parameters(prm);
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
    all.for_each_row([&](const auto &row) {
      row.check(all.input, grid, all.output, columns);
    });
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

    const PostprocessorContext<dim> context{
      all.input, grid, all.pressure, all.extent, directory, communicator};
    all.for_each_row(
      [&](const auto &row) { row.make(context, all.output, all.list); });
    for (const ScoreParameters &score : all.score_parameters)
      all.scores.emplace_back(score, all.input);
    make_frames(context, all.output, all.list);
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
    return !implementation->template instances<WallForces<dim>>().empty();
  }

  template <int dim>
  std::vector<NamedPlace<dim>>
  PostprocessorList<dim>::places() const
  {
    std::vector<NamedPlace<dim>> result;
    for (const auto &probe : implementation->template instances<Probes<dim>>())
      result.push_back({probe.name, probe.position});
    for (const NamedPlace<dim> &track : tracked_places())
      result.push_back(track);
    for (const auto &gauge :
         implementation->template instances<WaterLevel<dim>>())
      result.push_back({gauge.name, gauge.position});
    return result;
  }

  template <int dim>
  std::vector<NamedPlace<dim>>
  PostprocessorList<dim>::tracked_places() const
  {
    std::vector<NamedPlace<dim>> result;
    for (const auto &track :
         implementation->template instances<TrackedPoints<dim>>())
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
