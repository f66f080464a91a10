// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/statistics_table.h>

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

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

  StatisticsTable::StatisticsTable(const std::string &file_to_write,
                                   const bool         this_rank_writes)
    : filename(file_to_write)
    , writes(this_rank_writes)
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
    if (filename.empty() || !writes)
      return;

    if (!file.is_open())
      {
        file.open(filename);
        file.append(header_line());
      }
    fmt::memory_buffer line;
    const auto         end = std::back_inserter(line);
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

  std::string
  StatisticsTable::header_line() const
  {
    std::string line;
    for (const std::string &name : column_names)
      line += (line.empty() ? "" : ",") + csv_field(name);
    return line + "\n";
  }

  void
  StatisticsTable::save_or_load(StateArchive &archive)
  {
    file.synchronise(); // what a checkpoint counts on must be on the disk
    std::uint64_t length = file.length();
    archive("rows", rows);
    archive("columns", column_names);
    archive("length", length);
    if (!archive.loading())
      return;

    index.clear();
    for (std::size_t c = 0; c < column_names.size(); ++c)
      index.emplace(column_names[c], c);
    columns.assign(column_names.size(), {});
    if (filename.empty())
      {
        for (auto &column : columns)
          column.assign(rows, std::numeric_limits<double>::quiet_NaN());
        return;
      }
    parse(checked_file::read(filename, length));
    if (writes)
      file.continue_at(filename, length);
  }

  void
  StatisticsTable::parse(const std::string &text)
  {
    const std::string header = header_line();
    bool              valid  = text.compare(0, header.size(), header) == 0;
    const char       *next   = text.data() + header.size();
    const char *const end    = text.data() + text.size();
    for (std::size_t row = 0; row < rows && valid; ++row)
      for (std::size_t c = 0; c < columns.size() && valid; ++c)
        {
          double     value     = std::numeric_limits<double>::quiet_NaN();
          const auto field     = std::from_chars(next, end, value);
          const char separator = (c + 1 < columns.size() ? ',' : '\n');
          valid                = field.ptr < end && *field.ptr == separator;
          next                 = field.ptr + 1;
          columns[c].push_back(value);
        }
    if (!valid || next != end)
      throw FileError(filename +
                      ": does not hold the rows that the checkpoint goes on "
                      "from; put the file of that run back, or start again.");
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
