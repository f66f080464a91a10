// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/remaining_time.h>
#include <seiche/utilities/readable.h>
#include <seiche/utilities/timer_tree.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace seiche
{
  namespace
  {
    constexpr double longest_estimate = 1e8; // [s]

    std::string
    clock_time(const double seconds_from_now)
    {
      const std::time_t end =
        std::time(nullptr) + static_cast<std::time_t>(seconds_from_now);
      std::tm local{};
      localtime_r(&end, &local);
      return fmt::format("{:02}:{:02}", local.tm_hour, local.tm_min);
    }
  } // namespace



  RemainingTime::RemainingTime(const double end_of_run)
    : end_time(end_of_run)
    , last_wall(wall_clock())
  {}



  void
  RemainingTime::measure(const double time, const double now)
  {
    // averaged over some 20 steps
    const double new_rate =
      (time - last_time) / std::max(now - last_wall, 1e-9);
    rate      = (rate == 0. ? new_rate : rate + 0.05 * (new_rate - rate));
    last_wall = now;
    last_time = time;
  }



  double
  RemainingTime::seconds() const
  {
    return (end_time - last_time) / std::max(rate, 1e-300);
  }



  std::string
  RemainingTime::text() const
  {
    const double left = seconds();
    if (std::isnan(left))
      return "";
    return left < longest_estimate ?
             ", " + readable_duration(left) + " left" :
             ", more than " + readable_duration(longest_estimate) + " left";
  }



  std::string
  RemainingTime::text_with_end() const
  {
    const double left = seconds();
    return left > 0. && left < longest_estimate ?
             fmt::format(" | {} left, ends {}",
                         readable_duration(left),
                         clock_time(left)) :
             "";
  }



  void
  RemainingTime::save_or_load(StateArchive &archive)
  {
    archive("time", last_time);
    if (archive.loading())
      last_wall = wall_clock();
  }
} // namespace seiche
