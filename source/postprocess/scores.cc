// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/postprocess/scores.h>
#include <seiche/scene/entry_values.h>

#include <deal.II/base/parameter_handler.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace seiche
{
  namespace
  {
    struct MeasureEntry
    {
      const char *name;
      double (*of)(const ScoreSums &);
    };

    constexpr std::array<MeasureEntry, 5> measure_table = {
      {{"rms",
        [](const ScoreSums &s) { return std::sqrt(s.square / s.weights); }},
       {"mean", [](const ScoreSums &s) { return s.sum / s.weights; }},
       {"maximum", [](const ScoreSums &s) { return s.largest; }},
       {"last", [](const ScoreSums &s) { return s.last; }},
       {"mean absolute",
        [](const ScoreSums &s) { return s.absolute / s.weights; }}}};

    struct InterpolationEntry
    {
      const char              *name;
      TimeTable::Interpolation value;
    };

    constexpr std::array<InterpolationEntry, 2> interpolation_table = {
      {{"linear", TimeTable::Interpolation::linear},
       {"spline", TimeTable::Interpolation::akima}}};

    template <typename Table>
    std::string
    names(const Table &table)
    {
      std::string result;
      for (const auto &entry : table)
        result += (result.empty() ? "" : "|") + std::string(entry.name);
      return result;
    }

    /// The pattern of the entry knows the names of the table alone.
    template <typename Table>
    const auto &
    entry_of(const Table &table, const std::string &name)
    {
      return *std::find_if(table.begin(), table.end(), [&](const auto &entry) {
        return name == entry.name;
      });
    }
  } // namespace

  using namespace dealii;

  void
  ScoreParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Column",
                      column,
                      "Column of statistics.csv, with its unit.",
                      Patterns::Anything(),
                      /*has_to_be_set=*/true);
    prm.add_parameter("Time column",
                      time_column,
                      "Time of the values: the end of the step, or the time "
                      "of the pressure.",
                      Patterns::Selection("time|pressure_time"));
    prm.add_parameter("Reference",
                      reference,
                      "Reference as a function of t, in the unit of the "
                      "column.");
    prm.add_parameter("Reference table",
                      table,
                      "Reference as a CSV file with one header line, relative "
                      "to the parameter file; instead of \"Reference\".",
                      Patterns::FileName());
    prm.add_parameter("Table columns",
                      table_columns,
                      "Columns of time and value in the table, counted from "
                      "0.");
    prm.add_parameter("Table factors",
                      table_factors,
                      "Factors that turn time and value of the table into "
                      "SI units.");
    prm.add_parameter("Interpolation",
                      interpolation,
                      "Between the rows of the table.",
                      Patterns::Selection(names(interpolation_table)));
    prm.add_parameter(
      "Measure",
      measure,
      "What is made of the deviations. rms, mean and mean absolute weigh each "
      "row by its step size; maximum is that of the absolute value.",
      Patterns::Selection(names(measure_table)));
    prm.add_parameter("Relative",
                      relative,
                      "Deviation is value/reference - 1 instead of value - "
                      "reference.");
    prm.add_parameter("Times",
                      times,
                      "Compare at these times only; empty: at every step. [s]");
    prm.add_parameter("From", from, "Begin of the window. [s]");
    prm.add_parameter("To",
                      to,
                      "End of the window; 0: the end of the run. [s]",
                      Patterns::Double(0.));
    prm.add_parameter("Scale",
                      scale,
                      "The result is divided by this, in the unit of the "
                      "column.",
                      Patterns::Double());
  }

  void
  ScoreParameters::check(const InputFile                &input,
                         const std::vector<std::string> &columns,
                         const double                    end_time) const
  {
    const std::string section = std::string(kind) + " " + name;
    const std::string hint    = nearest_hint(column, columns);
    input.require(std::find(columns.begin(), columns.end(), column) !=
                    columns.end(),
                  section + "/Column",
                  "the statistics have no such column" +
                    (hint.empty() ? "." : hint) + " Columns are " +
                    quoted_list(columns) + ".");
    input.require(table.empty() || !input.is_set(section + "/Reference"),
                  section + "/Reference",
                  "there is a \"Reference table\" too; keep one of the two.");
    for (const char *entry :
         {"/Table columns", "/Table factors", "/Interpolation"})
      input.read_only_if(!table.empty(), section + entry, "Reference table");
    input.require(scale != 0., section + "/Scale", "the scale must not be 0.");
    input.require(to == 0. || to >= from,
                  section + "/To",
                  "the window must not end before \"From\"; 0 means the end "
                  "of the run.");
    const double slack = 1e-9 * end_time;
    input.read_only_if(from <= end_time + slack,
                       section + "/From",
                       "a Time/End time after it");
    const Score score(*this, input);
    input.read_only_if(score.last_time() <= end_time + slack,
                       section + "/Times",
                       "a Time/End time after the last one");
  }

  Score::Score(const ScoreParameters &score_parameters, const InputFile &input)
    : parameters(score_parameters)
    , measure(entry_of(measure_table, parameters.measure).of)
  {
    const std::string section =
      std::string(ScoreParameters::kind) + " " + parameters.name;
    if (!parameters.times.empty())
      times =
        entry_values::numbers(input, section + "/Times", parameters.times);
    if (parameters.table.empty())
      {
        expression = std::make_unique<const Expression<2>>(
          input, section + "/Reference", parameters.reference, 1);
        return;
      }

    table = std::make_unique<const TimeTable>(
      input,
      CsvCurve::Entries{section + "/Reference table",
                        parameters.table,
                        section + "/Table columns",
                        parameters.table_columns,
                        section + "/Table factors",
                        parameters.table_factors},
      entry_of(interpolation_table, parameters.interpolation).value);
  }

  std::optional<double>
  Score::evaluate(const StatisticsTable &statistics, std::string &warning) const
  {
    if (!statistics.has(parameters.column))
      {
        warning = "the run has written no column " + parameters.column;
        return {};
      }
    ScoreSums              sums;
    const std::vector<Row> compared = rows(statistics, warning);
    for (const Row &row : compared)
      {
        if (table && !table->covers(row.time))
          {
            warning =
              fmt::format("the table does not cover t = {} s", row.time);
            return {};
          }
        const double reference = table ?
                                   table->value(row.time) :
                                   expression->value(Point<2>(), row.time);
        const double deviation = parameters.relative ?
                                   row.value / reference - 1. :
                                   row.value - reference;
        if (!std::isfinite(deviation))
          {
            warning =
              fmt::format("the reference is zero at t = {} s", row.time);
            return {};
          }
        sums.add(row.weight, deviation);
      }
    if (compared.empty())
      return {};

    const double result = measure(sums) / parameters.scale;
    if (std::isfinite(result))
      return result;
    warning = "no step lies in the window (only the start of the run)";
    return {};
  }
} // namespace seiche
