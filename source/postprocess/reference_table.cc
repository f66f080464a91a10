// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/reference_table.h>
#include <seiche/utilities/regular_file.h>

#include <deal.II/base/exceptions.h>

#include <boost/math/interpolators/makima.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>

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
  } // namespace

  ReferenceTable::ReferenceTable(
    const std::string                              &filename,
    const std::array<unsigned int, 2>              &columns,
    const std::array<double, 2>                    &factors,
    const Interpolation                             interpolation,
    const std::function<void(const std::string &)> &fail)
  {
    if (const std::string problem = problem_of_file(filename, largest_table);
        !problem.empty())
      fail(fmt::format("the reference table {}: {}. Names are relative to the "
                       "parameter file.",
                       filename,
                       problem));
    std::ifstream stream(filename);
    std::string   line;
    if (!stream || stream.peek() == std::ifstream::traits_type::eof())
      fail(fmt::format("the reference table {} cannot be read or is empty.",
                       filename));

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
            if (to_number(fields[0], row[0]))
              fail(place + "the first line must be a header with the names of "
                           "the columns, not numbers.");
            continue;
          }
        for (const unsigned int k : {0u, 1u})
          if (columns[k] >= fields.size())
            fail(fmt::format("{}there are {} columns, number {} (counted from "
                             "0) is asked for; change \"Table columns\".",
                             place,
                             fields.size(),
                             columns[k]));
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
          }
        if (!times.empty() && row[0] <= times.back())
          fail(place + "times must increase from row to row.");
        times.push_back(row[0]);
        values.push_back(row[1]);
      }
    const std::size_t least = interpolation == Interpolation::spline ? 4 : 2;
    if (times.size() < least)
      fail(fmt::format("the reference table {} has {} rows of numbers; this "
                       "interpolation needs at least {}.",
                       filename,
                       times.size(),
                       least));

    if (interpolation == Interpolation::spline)
      {
        using Spline = boost::math::interpolators::makima<std::vector<double>>;
        const auto curve =
          std::make_shared<Spline>(std::vector<double>(times),
                                   std::vector<double>(values));
        spline = [curve](const double time) { return (*curve)(time); };
      }
  }

  bool
  ReferenceTable::covers(const double time) const
  {
    // times of steps and of tables carry the rounding of their products
    const double slack = 1e-9 * (times.back() - times.front());
    return time >= times.front() - slack && time <= times.back() + slack;
  }

  double
  ReferenceTable::value(const double time_asked) const
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
} // namespace seiche
