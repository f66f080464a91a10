// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/utilities/readable.h>

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace seiche
{
  std::string
  readable_duration(const double seconds)
  {
    constexpr double hour = 3600., day = 24. * hour, year = 365.25 * day;
    if (seconds >= 2. * year)
      return fmt::format("{:.3g} years", seconds / year);
    if (seconds >= 3. * day)
      return fmt::format("{:.0f} days", seconds / day);
    if (seconds >= 1.5 * hour)
      return fmt::format("{:.1f} h", seconds / hour);
    if (seconds >= 90.)
      return fmt::format("{:.1f} min", seconds / 60.);
    return seconds < 9.95 ? fmt::format("{:.2g} s", seconds) :
                            fmt::format("{:.0f} s", seconds);
  }

  std::string
  readable_size(const double bytes)
  {
    constexpr std::array<const char *, 6> units = {
      {"B", "kB", "MB", "GB", "TB", "PB"}};
    double       value = bytes;
    unsigned int unit  = 0;
    for (; value >= 999.5 && unit + 1 < units.size(); ++unit)
      value /= 1000.;
    return value < 9.95 ? fmt::format("{:.2g} {}", value, units[unit]) :
                          fmt::format("{:.0f} {}", value, units[unit]);
  }

  std::string
  readable_count(const double number)
  {
    return number < 1e7 ? fmt::format("{:.0f}", number) :
                          fmt::format("{:.2g}", number);
  }
} // namespace seiche
