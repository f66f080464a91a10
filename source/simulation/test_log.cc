// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/test_log.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace seiche
{
  namespace
  {
    // of a step; Krylov iterations depend on rounding and on preconditioners
    constexpr unsigned int newton_range = 10, krylov_range = 200;

    /// Counts differ a little between machines: "1-10", "11-100", ...
    std::string
    count_range(const double count, const unsigned int first)
    {
      if (count <= 0.)
        return "0";
      unsigned int lower = 0, upper = first;
      while (count > upper)
        {
          lower = upper;
          upper *= 10;
        }
      return fmt::format("{}-{}", lower + 1, upper);
    }

    /// Six digits; what is only rounding error is zero.
    std::string
    rounded(const double value)
    {
      return std::abs(value) < 1e-9 ? "0" : fmt::format("{:.6g}", value);
    }

    std::string
    rounded(const nlohmann::ordered_json &value)
    {
      if (value.is_number_float())
        return rounded(value.get<double>());
      if (!value.is_array())
        return value.dump();
      std::string text;
      for (const auto &entry : value)
        text += (text.empty() ? "" : " ") + rounded(entry);
      return text;
    }
  } // namespace



  void
  TestLog::open()
  {
    file.open("output");
  }



  void
  TestLog::close()
  {
    if (file.is_open())
      file.close();
  }



  void
  TestLog::line(const std::string &text)
  {
    std::cout << text << std::endl;
    if (file.is_open())
      file.append(text + "\n");
  }



  void
  TestLog::step(const double       time,
                const double       dt,
                const double       energy,
                const unsigned int newton,
                const unsigned int krylov)
  {
    line(fmt::format("t {} dt {} energy {} Newton {} Krylov {}",
                     rounded(time),
                     rounded(dt),
                     rounded(energy),
                     count_range(newton, newton_range),
                     count_range(krylov, krylov_range)));
  }



  void
  TestLog::summary(const nlohmann::ordered_json &complete)
  {
    for (const char *key : {"dim",
                            "points",
                            "cells",
                            "occupied_cells_max",
                            "end_time",
                            "steps",
                            "rejected_steps",
                            "accepted_failing_steps",
                            "points_held_back"})
      if (complete.contains(key))
        line(fmt::format("{} {}", key, rounded(complete[key])));

    const double steps = std::max(1., complete.value("steps", 1.));
    for (const auto &[key, width] :
         {std::make_pair("newton_iterations", newton_range),
          std::make_pair("krylov_iterations", krylov_range)})
      if (complete.contains(key) && complete[key].is_number())
        line(
          fmt::format("{} per step {}",
                      key,
                      count_range(complete[key].get<double>() / steps, width)));

    for (const char *part : {"ledger", "errors"})
      if (complete.contains(part))
        for (const auto &[name, value] : complete[part].items())
          line(fmt::format("{} {} {}", part, name, rounded(value)));
  }
} // namespace seiche
