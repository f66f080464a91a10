// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/scores.h>

#include <fmt/format.h>

#include <cmath>

// The part of Score that knows which rows of the statistics count.
namespace seiche
{
  namespace
  {
    constexpr double  negligible  = 0.01; // of a window that a table leaves out
    const std::string step_column = "dt [s]";
  } // namespace

  void
  Score::request(StatisticsTable &statistics) const
  {
    for (const std::string &column :
         {parameters.column, parameters.time_column + " [s]", step_column})
      statistics.keep(column);
  }

  std::vector<Score::Row>
  Score::sample(const std::vector<Row> &all, std::string &warning) const
  {
    std::vector<Row> samples;
    for (const double time : times)
      {
        // a row that ends at the time asked for, up to rounding, serves too
        const double slack = 1e-9 * std::abs(time);
        std::size_t  next  = 0;
        while (next < all.size() && all[next].time < time - slack)
          ++next;
        if (next == all.size() || (next == 0 && all[0].time > time + slack))
          {
            warning = fmt::format("the run gives no value at t = {} s", time);
            return {};
          }
        const Row   &after = all[next];
        const double share =
          next == 0 || after.time - time <= slack ?
            1. :
            (time - all[next - 1].time) / (after.time - all[next - 1].time);
        samples.push_back(
          {time,
           share * after.value +
             (share < 1. ? (1. - share) * all[next - 1].value : 0.),
           1.});
      }
    return samples;
  }

  std::vector<Score::Row>
  Score::rows(const StatisticsTable &statistics, std::string &warning) const
  {
    const auto &values = statistics.column(parameters.column);
    const auto &time   = statistics.column(parameters.time_column + " [s]");
    const auto &dt     = statistics.column(step_column);

    std::vector<Row> all;
    for (std::size_t i = (parameters.is_of_pressure() ? 1 : 0);
         i < values.size();
         ++i)
      if (std::isfinite(values[i]))
        all.push_back({time[i], values[i], dt[i]});
    if (!times.empty())
      return sample(all, warning);

    // steps end where they should up to rounding
    const double     slack = 1e-9 * (all.empty() ? 0. : all.back().time);
    std::vector<Row> window;
    double           end = 0.; // of the window asked for
    for (const Row &row : all)
      if (row.time >= parameters.from - slack &&
          (parameters.to == 0. || row.time <= parameters.to + slack))
        {
          end = row.time;
          if (!table || table->covers(row.time))
            window.push_back(row);
        }
    if (window.empty())
      warning = "no step of the run lies in the window (and in the table)";
    else if (end - window.back().time > negligible * (end - parameters.from))
      warning = fmt::format("only to t = {:.6g} s, where the table ends; the "
                            "run goes on to {:.6g} s. Set \"To\"",
                            window.back().time,
                            end);
    return window;
  }
} // namespace seiche
