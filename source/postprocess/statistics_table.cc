// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/statistics_table.h>

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>

#include <cmath>

namespace seiche
{
  namespace
  {
    /// A name as a field of a CSV file: quoted where it must be (RFC 4180).
    std::string
    csv_field(const std::string &name)
    {
      if (name.find_first_of(",\"\n") == std::string::npos)
        return name;
      std::string quoted = "\"";
      for (const char c : name)
        quoted += (c == '"' ? std::string("\"\"") : std::string(1, c));
      return quoted + "\"";
    }
  } // namespace

  StatisticsTable::StatisticsTable(const std::string &file_to_write)
    : filename(file_to_write)
  {}

  void
  StatisticsTable::set(const std::string &name, const double value)
  {
    const auto  found = index.find(name);
    std::size_t column_index;
    if (found == index.end())
      {
        AssertThrow(rows == 0,
                    dealii::ExcMessage("Column \"" + name +
                                       "\" appears after the first row."));
        column_index = column_names.size();
        index.emplace(name, column_index);
        column_names.push_back(name);
        columns.emplace_back();
      }
    else
      column_index = found->second;
    Assert(columns[column_index].size() == rows,
           dealii::ExcMessage("Column \"" + name +
                              "\" is set twice in a row."));
    columns[column_index].push_back(value);
  }

  void
  StatisticsTable::end_row()
  {
    ++rows;
    for (std::size_t c = 0; c < columns.size(); ++c)
      AssertThrow(columns[c].size() == rows,
                  dealii::ExcMessage("Column \"" + column_names[c] +
                                     "\" is not set in this row."));
    if (filename.empty())
      return;

    fmt::memory_buffer line;
    const auto         end = std::back_inserter(line);
    if (!file.is_open())
      {
        file.open(filename);
        for (std::size_t c = 0; c < columns.size(); ++c)
          fmt::format_to(end,
                         "{}{}",
                         c == 0 ? "" : ",",
                         csv_field(column_names[c]));
        fmt::format_to(end, "\n");
      }
    for (std::size_t c = 0; c < columns.size(); ++c)
      {
        const double value = columns[c].back();
        if (c > 0)
          fmt::format_to(end, ",");
        if (std::isfinite(value)) // a missing value is an empty field
          fmt::format_to(end, "{}", value);
      }
    fmt::format_to(end, "\n");
    file.append(fmt::to_string(line));
  }

  const std::vector<double> &
  StatisticsTable::column(const std::string &name) const
  {
    Assert(has(name), dealii::ExcMessage("There is no column " + name));
    return columns[index.at(name)];
  }

  bool
  StatisticsTable::has(const std::string &name) const
  {
    return index.count(name) > 0;
  }
} // namespace seiche
