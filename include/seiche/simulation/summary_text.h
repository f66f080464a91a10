// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_simulation_summary_text_h
#define seiche_simulation_summary_text_h

#include <nlohmann/json.hpp>

#include <string>

namespace seiche
{
  /// What a run that has finished says of its results, alarms included.
  std::string
  finished_text(const nlohmann::ordered_json &summary,
                const std::string            &directory);

  /// What it says of its verdicts.
  std::string
  verdict_text(const nlohmann::ordered_json &summary);
} // namespace seiche

#endif
