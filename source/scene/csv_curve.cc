// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/csv_curve.h>
#include <seiche/scene/csv_file.h>
#include <seiche/scene/entry_values.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace seiche
{
  namespace
  {
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

    /// A row of the file, in SI units.
    class CurveReader
    {
    public:
      CurveReader(const InputFile         &input_file,
                  const CsvCurve::Entries &curve_entries)
        : columns_path(curve_entries.columns_path)
        , columns(column_numbers(input_file, curve_entries))
        , factors(factors_to_si(input_file, curve_entries))
      {}

      void
      read(const CsvFile::Row &row, CsvCurve &curve) const
      {
        for (const unsigned int column : columns)
          if (column >= row.fields.size())
            row.file.fail(
              fmt::format("{}there are {} columns, number {} (counted from "
                          "0) is asked for; change \"{}\".",
                          row.place,
                          row.fields.size(),
                          column,
                          columns_path.substr(columns_path.find('/') + 1)));
        if (row.fields[columns[0]].empty() && row.fields[columns[1]].empty())
          return;
        double values[2];
        for (const unsigned int k : {0u, 1u})
          {
            values[k] = factors[k] * row.number(columns[k]);
            if (!std::isfinite(values[k]))
              row.file.fail(
                fmt::format("{}\"{}\" times its factor is too large.",
                            row.place,
                            row.fields[columns[k]]));
          }
        if (!curve.times.empty() && values[0] <= curve.times.back())
          row.file.fail(row.place + "times must increase from row to row.");
        curve.times.push_back(values[0]);
        curve.values.push_back(values[1]);
      }

    private:
      const std::string                &columns_path;
      const std::array<unsigned int, 2> columns;
      const std::array<double, 2>       factors;
    };
  } // namespace

  CsvCurve::CsvCurve(const InputFile &input, const Entries &entries)
  {
    const CurveReader reader(input, entries);
    const CsvFile     file(input, entries.file_path, entries.file);
    filename = file.filename;
    file.for_each_row(
      [&](const CsvFile::Row &row) { reader.read(row, *this); });
  }
} // namespace seiche
