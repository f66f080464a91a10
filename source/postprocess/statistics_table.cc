// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/statistics_table.h>
#include <seiche/utilities/regular_file.h>

#include <deal.II/base/exceptions.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
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
  StatisticsTable::keep(const std::string &name)
  {
    kept[name];
  }

  void
  StatisticsTable::put(const std::size_t column_index, const double value)
  {
    row[column_index] = value;
    const auto column = kept.find(column_names[column_index]);
    if (column != kept.end())
      column->second.push_back(value);
    ++n_set;
  }

  void
  StatisticsTable::set(const std::string &name, const double value)
  {
    const auto [place, is_new] = index.emplace(name, column_names.size());
    if (is_new)
      {
        AssertThrow(rows == 0,
                    dealii::ExcMessage("Column \"" + name +
                                       "\" appears after the first row."));
        column_names.push_back(name);
        row.emplace_back();
      }
    put(place->second, value);
  }

  void
  StatisticsTable::end_row()
  {
    ++rows;
    AssertThrow(n_set == row.size(),
                dealii::ExcMessage("A column is not set once in this row."));
    n_set = 0;
    if (filename.empty() || !writes)
      return;

    if (!file.is_open())
      {
        file.open(filename);
        file.append(header_line());
      }
    fmt::memory_buffer line;
    const auto         end = std::back_inserter(line);
    for (std::size_t c = 0; c < row.size(); ++c)
      {
        if (c > 0)
          fmt::format_to(end, ",");
        if (std::isfinite(row[c])) // a missing value is an empty field
          fmt::format_to(end, "{}", row[c]);
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

    if (rows == 0)
      return; // there was no file yet
    index.clear();
    for (std::size_t c = 0; c < column_names.size(); ++c)
      index.emplace(column_names[c], c);
    row.assign(column_names.size(), missing);
    for (auto &column : kept)
      column.second.assign(filename.empty() ? rows : 0, missing);
    if (filename.empty())
      return;
    read_rows(length);
    if (writes)
      file.continue_at(filename, length);
  }

  void
  StatisticsTable::read_rows(const std::size_t length)
  {
    const std::string problem =
      problem_of_file(filename, std::numeric_limits<std::uintmax_t>::max());
    if (!problem.empty())
      throw FileError(filename + ": " + problem + ".");
    std::ifstream stream(filename);
    std::string   line;
    std::size_t   done  = 0; // bytes
    bool          valid = true;
    // line by line: the file may be larger than all the rest of the run
    for (std::size_t r = 0; r <= rows && valid; ++r)
      {
        valid = static_cast<bool>(std::getline(stream, line));
        line += '\n';
        done += line.size();
        valid = valid && (r == 0 ? line == header_line() : parse(line));
      }
    n_set = 0;
    if (!valid || done != length)
      throw FileError(filename +
                      ": does not hold the rows that the checkpoint goes on "
                      "from; put the file of that run back, or start again.");
  }

  bool
  StatisticsTable::parse(const std::string &line)
  {
    const char       *next = line.data();
    const char *const end  = next + line.size();
    for (std::size_t c = 0; c < row.size(); ++c)
      {
        double     value     = missing;
        const auto field     = std::from_chars(next, end, value);
        const char separator = (c + 1 < row.size() ? ',' : '\n');
        if (field.ptr == end || *field.ptr != separator)
          return false;
        next = field.ptr + 1;
        put(c, value);
      }
    return next == end;
  }

  const std::vector<double> &
  StatisticsTable::column(const std::string &name) const
  {
    Assert(kept.count(name) > 0,
           dealii::ExcMessage("Column " + name + " is not kept"));
    return kept.at(name);
  }

  double
  StatisticsTable::last(const std::string &name) const
  {
    Assert(has(name), dealii::ExcMessage("There is no column " + name));
    return row[index.at(name)];
  }

  bool
  StatisticsTable::has(const std::string &name) const
  {
    return index.count(name) > 0;
  }
} // namespace seiche
