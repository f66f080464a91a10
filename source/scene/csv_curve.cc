// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/csv_curve.h>
#include <seiche/scene/entry_values.h>
#include <seiche/utilities/regular_file.h>

#include <fmt/format.h>

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
    column_numbers(const InputFile &input, const CsvCurve::Entries &entries)
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
    factors_to_si(const InputFile &input, const CsvCurve::Entries &entries)
    {
      const auto factors =
        entry_values::numbers(input, entries.factors_path, entries.factors);
      input.require(factors.size() == 2 && factors[0] > 0.,
                    entries.factors_path,
                    "two factors are needed: of the time (positive) and of the "
                    "value.");
      return {{factors[0], factors[1]}};
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

    /// What the lines of one file mean.
    class CurveReader
    {
    public:
      CurveReader(const InputFile         &input_file,
                  const CsvCurve::Entries &curve_entries,
                  const std::string       &name)
        : input(input_file)
        , entries(curve_entries)
        , filename(name)
        , columns(column_numbers(input, entries))
        , factors(factors_to_si(input, entries))
      {}

      void
      read(CsvCurve &curve) const
      {
        if (const std::string problem =
              problem_of_file(filename, largest_table);
            !problem.empty())
          fail(fmt::format("the table {}: {}. Names are relative to the "
                           "parameter file.",
                           filename,
                           problem));
        std::ifstream stream(filename);
        std::string   line;
        if (!stream || stream.peek() == std::ifstream::traits_type::eof())
          fail(
            fmt::format("the table {} cannot be read or is empty.", filename));
        bool header = false;
        for (unsigned int number = 1; std::getline(stream, line); ++number)
          {
            const std::string place = fmt::format("{}:{}: ", filename, number);
            line                    = trimmed(line);
            if (line.empty() || line[0] == '#')
              continue;
            const std::vector<std::string> fields = split(line);
            if (header)
              read_row(fields, place, curve);
            else
              check_header(line, fields, place);
            header = true;
          }
      }

    private:
      [[noreturn]] void
      fail(const std::string &problem) const
      {
        input.fail(entries.file_path, problem);
      }

      void
      check_header(const std::string              &line,
                   const std::vector<std::string> &fields,
                   const std::string              &place) const
      {
        if (fields.size() == 1 &&
            line.find_first_of(";\t") != std::string::npos)
          fail(place + "columns are separated by commas, and numbers have "
                       "decimal points.");
        double number;
        if (to_number(fields[0], number))
          fail(place + "the first line must be a header with the names of "
                       "the columns, not numbers.");
      }

      void
      read_row(const std::vector<std::string> &fields,
               const std::string              &place,
               CsvCurve                       &curve) const
      {
        for (const unsigned int column : columns)
          if (column >= fields.size())
            fail(fmt::format("{}there are {} columns, number {} (counted from "
                             "0) is asked for; change \"{}\".",
                             place,
                             fields.size(),
                             column,
                             entries.columns_path.substr(
                               entries.columns_path.find('/') + 1)));
        if (fields[columns[0]].empty() && fields[columns[1]].empty())
          return;
        double row[2];
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
        if (!curve.times.empty() && row[0] <= curve.times.back())
          fail(place + "times must increase from row to row.");
        curve.times.push_back(row[0]);
        curve.values.push_back(row[1]);
      }

      const InputFile                  &input;
      const CsvCurve::Entries          &entries;
      const std::string                &filename;
      const std::array<unsigned int, 2> columns;
      const std::array<double, 2>       factors;
    };
  } // namespace

  CsvCurve::CsvCurve(const InputFile &input, const Entries &entries)
    : filename(as_typed(input.file_beside(entries.file)))
  {
    CurveReader(input, entries, filename).read(*this);
  }
} // namespace seiche
