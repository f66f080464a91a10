// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/summary_text.h>

#include <fmt/format.h>

namespace seiche
{
  namespace
  {
    std::string
    alarm_text(const nlohmann::ordered_json &summary)
    {
      std::string text;
      if (summary.contains("alarms"))
        for (const auto &[name, value] : summary["alarms"].items())
          text += fmt::format("{} {} {:.2g} %",
                              text.empty() ? "; BEWARE:" : ",",
                              name,
                              100. * value.get<double>());
      return text;
    }
  } // namespace



  std::string
  finished_text(const nlohmann::ordered_json &summary,
                const std::string            &directory)
  {
    return fmt::format(
      "finished{2}: results are in {0}/; look at {0}/summary.json and "
      "{0}/statistics.csv{1}",
      directory,
      alarm_text(summary),
      summary.contains("empty_since") ?
        fmt::format(", for no fluid is left since t = {:.6g} s",
                    summary["empty_since"].get<double>()) :
        "");
  }



  std::string
  verdict_text(const nlohmann::ordered_json &summary)
  {
    std::string text;
    for (const auto &failed : summary["verdict"]["failed"])
      text += (text.empty() ? "FAILED: " : "; ") + failed.get<std::string>();
    return "verdict: " + (text.empty() ? "passed" : text);
  }
} // namespace seiche
