// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_scores_h
#define seiche_postprocess_scores_h

#include <seiche/postprocess/statistics_table.h>
#include <seiche/scene/expression.h>
#include <seiche/scene/time_table.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Score NAME".
  struct ScoreParameters
  {
    static constexpr const char *kind = "Score";

    std::string name;
    std::string column;
    std::string time_column = "time";
    std::string reference   = "0";
    std::string table; // file name, or empty
    std::string table_columns = "0, 1";
    std::string table_factors = "1, 1";
    std::string interpolation = "linear";
    std::string measure       = "rms";
    bool        relative      = false;
    std::string times;      // [s], or empty
    double      from  = 0.; ///< [s]
    double      to    = 0.; ///< [s], 0: end of the run
    double      scale = 1.;

    /// True if the values are those of the pressure's time.
    bool
    is_of_pressure() const
    {
      return time_column == "pressure_time";
    }

    void
    add_parameters(dealii::ParameterHandler &prm);
    /// @p columns are the names that the statistics will have, until
    /// @p end_time [s].
    void
    check(const InputFile                &input,
          const std::vector<std::string> &columns,
          const double                    end_time) const;
  };

  /// What measures are made of: sums over the rows, weighted but for the last
  /// two.
  struct ScoreSums
  {
    double weights = 0., sum = 0., absolute = 0., square = 0.;
    double largest = 0.; ///< of the absolute values
    double last    = 0.;

    void
    add(const double weight, const double deviation)
    {
      weights += weight;
      sum += weight * deviation;
      absolute += weight * std::abs(deviation);
      square += weight * deviation * deviation;
      largest = std::max(largest, std::abs(deviation));
      last    = deviation;
    }
  };

  /**
   * @brief One number for a run: a column of the statistics against a
   * reference curve.
   *
   * Deviation d = value - reference, or value/reference - 1. Measures over
   * the rows in the window: rms and mean, weighted by the step size of each
   * row (so that steps of unequal size do not bias them); mean absolute, the
   * same of |d|; maximum of |d|; last d. With "Times" the column is
   * interpolated linearly there and all samples count alike. The result is
   * divided by "Scale".
   *
   * Left out: missing values, rows beyond the ends of a table, and with the
   * time of the pressure the row before the first step, when none had been
   * computed.
   */
  class Score
  {
  public:
    /// Reads the table; InputError with place.
    Score(const ScoreParameters &score_parameters, const InputFile &input);

    /// Ask for the columns that evaluate() reads. Local.
    void
    request(StatisticsTable &statistics) const;

    /// The score, or nothing: @p warning then says why. Local.
    std::optional<double>
    evaluate(const StatisticsTable &statistics, std::string &warning) const;

    /// Last of the times asked for [s]; 0 if there are none.
    double
    last_time() const
    {
      return times.empty() ? 0. : *std::max_element(times.begin(), times.end());
    }

    const ScoreParameters parameters;

  private:
    /// The column at some time of the run.
    struct Row
    {
      double time, value, weight;
    };

    /// Rows of the window, or samples at the times asked for.
    std::vector<Row>
    rows(const StatisticsTable &statistics, std::string &warning) const;

    std::vector<Row>
    sample(const std::vector<Row> &all, std::string &warning) const;

    double (*const measure)(const ScoreSums &);
    std::vector<double>                  times;
    std::unique_ptr<const Expression<2>> expression;
    std::unique_ptr<const TimeTable>     table;
  };
} // namespace seiche

#endif
