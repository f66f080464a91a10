// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/scene/csv_file.h>
#include <seiche/utilities/regular_file.h>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace seiche
{
  namespace
  {
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

    /// Relative to the current directory, if it lies there.
    std::string
    as_typed(const std::filesystem::path &file)
    {
      const auto near =
        file.lexically_proximate(std::filesystem::current_path()).string();
      return file.is_absolute() && near.rfind("..", 0) != 0 ? near :
                                                              file.string();
    }
  } // namespace

  std::string
  readable_file(const InputFile     &input,
                const std::string   &path,
                const std::string   &file,
                const std::uintmax_t largest)
  {
    const std::string filename = as_typed(input.file_beside(file));
    const std::string problem  = problem_of_file(filename, largest);
    input.require(problem.empty(),
                  path,
                  fmt::format("the file {}: {}. Names are relative to the "
                              "parameter file.",
                              filename,
                              problem));
    std::ifstream stream(filename);
    input.require(stream && stream.peek() != std::ifstream::traits_type::eof(),
                  path,
                  fmt::format("the file {} cannot be read or is empty.",
                              filename));
    return filename;
  }

  CsvFile::CsvFile(const InputFile   &input_file,
                   const std::string &path_of_entry,
                   const std::string &file)
    : filename(readable_file(input_file, path_of_entry, file))
    , input(input_file)
    , path(path_of_entry)
  {}

  void
  CsvFile::fail(const std::string &problem) const
  {
    input.fail(path, problem);
  }

  double
  CsvFile::Row::number(const unsigned int column) const
  {
    double result = 0.;
    if (!to_number(fields[column], result))
      file.fail(fmt::format("{}\"{}\" in column {} is no finite number.",
                            place,
                            fields[column],
                            column));
    return result;
  }

  void
  CsvFile::for_each_row(const std::function<void(const Row &)> &take) const
  {
    std::ifstream stream(filename);
    std::string   line;
    bool          header = false;
    for (unsigned int number = 1; std::getline(stream, line); ++number)
      {
        const std::string place = fmt::format("{}:{}: ", filename, number);
        line                    = trimmed(line);
        if (line.empty() || line[0] == '#')
          continue;
        const std::vector<std::string> fields = split(line);
        if (header)
          take({*this, place, fields});
        else
          check_header(line, fields, place);
        header = true;
      }
  }

  void
  CsvFile::check_header(const std::string              &line,
                        const std::vector<std::string> &fields,
                        const std::string              &place) const
  {
    if (fields.size() == 1 && line.find_first_of(";\t") != std::string::npos)
      fail(place + "columns are separated by commas, and numbers have "
                   "decimal points.");
    double number;
    if (to_number(fields[0], number))
      fail(place + "the first line must be a header with the names of the "
                   "columns, not numbers.");
  }
} // namespace seiche
