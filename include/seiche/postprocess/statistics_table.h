// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_statistics_table_h
#define seiche_postprocess_statistics_table_h

#include <seiche/utilities/checked_file.h>

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace seiche
{
  /**
   * @brief statistics.csv: one row a step, columns in order of first use.
   *
   * Values are kept for scores at the end of the run (8 bytes a value). The
   * columns are fixed by the first row. Rank 0 writes; all ranks hold the
   * values.
   */
  class StatisticsTable
  {
  public:
    /// File to write; empty: keep values only (other ranks, tests).
    explicit StatisticsTable(const std::string &filename);

    /// Value of this row; @p name with its unit in brackets: "front [m]". A
    /// value that is not finite is missing: an empty field, left out by scores.
    void
    set(const std::string &name, const double value);

    /// End the row and append it to the file. Every column must be set.
    void
    end_row();

    /// All values of a column; Assert if there is none.
    const std::vector<double> &
    column(const std::string &name) const;

    bool
    has(const std::string &name) const;

    const std::vector<std::string> &
    names() const
    {
      return column_names;
    }

  private:
    std::string                        filename;
    GrowingFile                        file;
    std::vector<std::string>           column_names;
    std::vector<std::vector<double>>   columns;
    std::map<std::string, std::size_t> index;
    std::size_t                        rows = 0;
  };
} // namespace seiche

#endif
