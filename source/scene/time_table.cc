// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/entry_values.h>
#include <seiche/scene/expression.h>
#include <seiche/scene/time_table.h>
#include <seiche/utilities/regular_file.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/function_cspline.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <boost/math/interpolators/makima.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace seiche
{
  namespace
  {
    constexpr std::uintmax_t largest_table = 64u << 20;

    std::string
    trimmed(const std::string &text)
    {
      const auto first = text.find_first_not_of(" \t\r\"");
      if (first == std::string::npos)
        return "";
      return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
    }

    std::vector<std::string>
    split(const std::string &line)
    {
      std::vector<std::string> fields;
      std::size_t              begin = 0;
      for (std::size_t comma;
           (comma = line.find(',', begin)) != std::string::npos;
           begin = comma + 1)
        fields.push_back(trimmed(line.substr(begin, comma - begin)));
      fields.push_back(trimmed(line.substr(begin)));
      return fields;
    }

    /// False if the text is no finite number (whatever the locale).
    bool
    to_number(const std::string &text, double &number)
    {
      const char *begin = text.data(), *end = begin + text.size();
      if (begin != end && *begin == '+')
        ++begin;
      const auto result = std::from_chars(begin, end, number);
      return result.ec == std::errc() && result.ptr == end &&
             std::isfinite(number);
    }

    constexpr unsigned int last_column = 9999;

    /// The two columns, counted from 0.
    std::array<unsigned int, 2>
    column_numbers(const InputFile &input, const TimeTable::Entries &entries)
    {
      const auto columns =
        entry_values::numbers(input, entries.columns_path, entries.columns);
      const auto is_number_of_column = [](const double value) {
        return value >= 0. && value <= last_column &&
               value == std::floor(value);
      };
      input.require(columns.size() == 2 && is_number_of_column(columns[0]) &&
                      is_number_of_column(columns[1]),
                    entries.columns_path,
                    fmt::format("two column numbers between 0 and {} are "
                                "needed: of the time and of the value.",
                                last_column));
      return {{static_cast<unsigned int>(columns[0]),
               static_cast<unsigned int>(columns[1])}};
    }

    std::array<double, 2>
    factors_to_si(const InputFile &input, const TimeTable::Entries &entries)
    {
      const auto factors =
        entry_values::numbers(input, entries.factors_path, entries.factors);
      input.require(factors.size() == 2 && factors[0] > 0.,
                    entries.factors_path,
                    "two factors are needed: of the time (positive) and of the "
                    "value.");
      return {{factors[0], factors[1]}};
    }

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

    /// Relative to the current directory, if it lies there.
    std::string
    as_typed(const std::filesystem::path &file)
    {
      const auto near =
        file.lexically_proximate(std::filesystem::current_path()).string();
      return file.is_absolute() && near.rfind("..", 0) != 0 ? near :
                                                              file.string();
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

  TimeTable::TimeTable(const InputFile    &input,
                       const Entries      &entries,
                       const Interpolation interpolation)
  {
    const auto        columns  = column_numbers(input, entries);
    const auto        factors  = factors_to_si(input, entries);
    const std::string filename = as_typed(input.file_beside(entries.file));
    const auto        fail     = [&](const std::string &problem) {
      input.fail(entries.file_path, problem);
    };
    if (const std::string problem = problem_of_file(filename, largest_table);
        !problem.empty())
      fail(fmt::format("the table {}: {}. Names are relative to the "
                       "parameter file.",
                       filename,
                       problem));
    std::ifstream stream(filename);
    std::string   line;
    if (!stream || stream.peek() == std::ifstream::traits_type::eof())
      fail(fmt::format("the table {} cannot be read or is empty.", filename));

    bool header = false;
    for (unsigned int number = 1; std::getline(stream, line); ++number)
      {
        const std::string place = fmt::format("{}:{}: ", filename, number);
        line                    = trimmed(line);
        if (line.empty() || line[0] == '#')
          continue;
        const std::vector<std::string> fields = split(line);
        double                         row[2];
        if (!header)
          {
            header = true;
            if (fields.size() == 1 &&
                line.find_first_of(";\t") != std::string::npos)
              fail(place + "columns are separated by commas, and numbers have "
                           "decimal points.");
            if (to_number(fields[0], row[0]))
              fail(place + "the first line must be a header with the names of "
                           "the columns, not numbers.");
            continue;
          }
        for (const unsigned int k : {0u, 1u})
          if (columns[k] >= fields.size())
            fail(fmt::format("{}there are {} columns, number {} (counted from "
                             "0) is asked for; change \"{}\".",
                             place,
                             fields.size(),
                             columns[k],
                             entries.columns_path.substr(
                               entries.columns_path.find('/') + 1)));
        if (fields[columns[0]].empty() && fields[columns[1]].empty())
          continue;
        for (const unsigned int k : {0u, 1u})
          {
            if (!to_number(fields[columns[k]], row[k]))
              fail(fmt::format("{}\"{}\" in column {} is no finite number.",
                               place,
                               fields[columns[k]],
                               columns[k]));
            row[k] *= factors[k];
            if (!std::isfinite(row[k]))
              fail(fmt::format("{}\"{}\" times its factor is too large.",
                               place,
                               fields[columns[k]]));
          }
        if (!times.empty() && row[0] <= times.back())
          fail(place + "times must increase from row to row.");
        times.push_back(row[0]);
        values.push_back(row[1]);
      }
    const std::size_t least = least_rows(interpolation);
    if (times.size() < least)
      fail(fmt::format("the table {} has {} rows of numbers; this "
                       "interpolation needs at least {}.",
                       filename,
                       times.size(),
                       least));
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
