// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_statistics_table_h
#define seiche_postprocess_statistics_table_h

#include <seiche/utilities/growing_file.h>
#include <seiche/utilities/state_archive.h>

#include <nlohmann/json.hpp>

#include <limits>
#include <map>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief statistics.csv: one row a step, columns in order of first use.
   *
   * Memory does not grow with the run, but for columns that scores ask for
   * (keep(), 8 bytes a row). The columns are fixed by the first row. Rank 0
   * writes; all ranks hold the values.
   */
  class StatisticsTable
  {
  public:
    /// What set() takes for a value that does not exist at this time.
    static constexpr double missing = std::numeric_limits<double>::quiet_NaN();

    /// File to write; empty: keep values only (tests). Ranks that do not
    /// write only read the file, in save_or_load().
    explicit StatisticsTable(const std::string &filename,
                             const bool         writes = true);

    /// From the first row on, column() has all values of this column. Before
    /// the first row, and before loading.
    void
    keep(const std::string &name);

    /// Value of this row; @p name with its unit in brackets: "front [m]". A
    /// value that is not finite is missing: an empty field, left out by scores.
    void
    set(const std::string &name, const double value);

    /// End the row and append it to the file. Every column must be set.
    void
    end_row();

    /// All values of a column that is kept; Assert if it is not.
    const std::vector<double> &
    column(const std::string &name) const;

    /// Value in the last row; Assert if there is no such column.
    double
    last(const std::string &name) const;

    bool
    has(const std::string &name) const;

    /// The rows so far. Only their number and the length of the file are
    /// saved: loading reads them from the file, exactly as they were, and
    /// rows that were appended later are cut off. FileError if the file does
    /// not hold them. Local.
    void
    save_or_load(StateArchive &archive);

    const std::vector<std::string> &
    names() const
    {
      return column_names;
    }

  private:
    std::string
    header_line() const;
    /// Fill the kept columns and the last row from the file, whose first
    /// @p length bytes must be these rows.
    void
    read_rows(const std::size_t length);
    /// Put the values of a line; false if they are not one a column.
    bool
    parse(const std::string &line);

    /// Take a value of row rows + 1.
    void
    put(const std::size_t column_index, const double value);

    std::string                                filename;
    bool                                       writes;
    GrowingFile                                file;
    std::vector<std::string>                   column_names;
    std::vector<double>                        row;
    std::map<std::string, std::size_t>         index;
    std::map<std::string, std::vector<double>> kept;
    std::size_t                                rows = 0, n_set = 0;
  };
} // namespace seiche

#endif
