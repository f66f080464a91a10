// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/expression.h>
#include <seiche/scene/time_table.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/function_cspline.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <boost/math/interpolators/makima.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seiche
{
  namespace
  {
    /// Rows that an interpolation needs.
    std::size_t
    least_rows(const TimeTable::Interpolation interpolation)
    {
      switch (interpolation)
        {
          case TimeTable::Interpolation::akima:
            return 4;
          case TimeTable::Interpolation::cubic:
            return 3;
          default:
            return 2;
        }
    }

    std::function<double(double)>
    make_spline(const std::vector<double>     &times,
                const std::vector<double>     &values,
                const TimeTable::Interpolation interpolation)
    {
      using Akima = boost::math::interpolators::makima<std::vector<double>>;
      using Cubic = dealii::Functions::CSpline<1>;
      if (interpolation == TimeTable::Interpolation::akima)
        {
          const auto curve =
            std::make_shared<Akima>(std::vector<double>(times),
                                    std::vector<double>(values));
          return [curve](const double time) { return (*curve)(time); };
        }
      if (interpolation == TimeTable::Interpolation::cubic)
        {
          const auto curve = std::make_shared<Cubic>(times, values);
          return [curve](const double time) {
            return curve->value(dealii::Point<1>(time));
          };
        }
      return {};
    }

    /// A name that an expression can call.
    bool
    is_one_word(const std::string &name)
    {
      return std::all_of(name.begin(),
                         name.end(),
                         [](const unsigned char c) {
                           return std::isalnum(c) || c == '_';
                         }) &&
             !name.empty() &&
             !std::isdigit(static_cast<unsigned char>(name[0]));
    }
  } // namespace

  TimeTable::TimeTable(const InputFile         &input,
                       const CsvCurve::Entries &entries,
                       const Interpolation      interpolation)
  {
    CsvCurve          curve(input, entries);
    const std::size_t least = least_rows(interpolation);
    input.require(curve.times.size() >= least,
                  entries.file_path,
                  fmt::format("the table {} has {} rows of numbers; this "
                              "interpolation needs at least {}.",
                              curve.filename,
                              curve.times.size(),
                              least));
    times  = std::move(curve.times);
    values = std::move(curve.values);
    spline = make_spline(times, values, interpolation);
  }

  bool
  TimeTable::covers(const double time) const
  {
    // times of steps and of tables carry the rounding of their products
    const double slack = 1e-9 * (times.back() - times.front());
    return time >= times.front() - slack && time <= times.back() + slack;
  }

  double
  TimeTable::value(const double time_asked) const
  {
    Assert(covers(time_asked), dealii::ExcInternalError());
    const double time =
      std::min(std::max(time_asked, times.front()), times.back());
    if (spline)
      return spline(time);
    const std::size_t next = std::max<std::ptrdiff_t>(
      std::lower_bound(times.begin(), times.end(), time) - times.begin(), 1);
    const double share =
      (time - times[next - 1]) / (times[next] - times[next - 1]);
    return (1. - share) * values[next - 1] + share * values[next];
  }

  void
  TableParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "File",
      file,
      "CSV file with one header line, relative to the parameter "
      "file. Every expression may call the table as NAME(t), "
      "as in 0.5*NAME(t - 1); it must cover the times that are "
      "asked for.",
      dealii::Patterns::FileName(),
      /*has_to_be_set=*/true);
    prm.add_parameter("Columns",
                      columns,
                      "Columns of time and value, counted from 0.");
    prm.add_parameter("Factors",
                      factors,
                      "Factors that turn time and value into SI units.");
    prm.add_parameter("Interpolation",
                      interpolation,
                      "Between the rows. cubic spline: velocity and "
                      "acceleration of a motion are continuous; akima: the "
                      "velocity is, without overshoot beside steps; linear: "
                      "not for motions, whose velocity would jump at each row.",
                      dealii::Patterns::Selection("cubic spline|akima|linear"));
  }

  TimeTable
  TableParameters::read(const InputFile &input) const
  {
    const std::string section = std::string(kind) + " " + name;
    return TimeTable(input,
                     {section + "/File",
                      file,
                      section + "/Columns",
                      columns,
                      section + "/Factors",
                      factors},
                     is_linear() ? TimeTable::Interpolation::linear :
                     interpolation == "akima" ?
                                   TimeTable::Interpolation::akima :
                                   TimeTable::Interpolation::cubic);
  }

  void
  TableParameters::check(const InputFile &input) const
  {
    const std::string path = std::string(kind) + " " + name + "/File";
    input.require(is_one_word(name) && !is_known_in_expressions(name),
                  path,
                  "expressions call a table by its name, \"" + name +
                    "\": this must be one word of letters, digits and _, and "
                    "no name that expressions know already.");
    (void)read(input);
    input.read_only_if(input.calls(name), path, "a call of " + name + "(t)");
  }

  std::vector<TableParameters>
  TableParameters::all(const InputFile &input)
  {
    std::vector<TableParameters> tables;
    for (const std::string &name : input.instances(kind))
      {
        const std::string section = std::string(kind) + " " + name + "/";
        TableParameters   table;
        table.name    = name;
        table.file    = input.value(section + "File");
        table.columns = input.value(section + "Columns", table.columns);
        table.factors = input.value(section + "Factors", table.factors);
        table.interpolation =
          input.value(section + "Interpolation", table.interpolation);
        tables.push_back(table);
      }
    return tables;
  }
} // namespace seiche
