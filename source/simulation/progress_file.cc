// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/simulation/progress_file.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/result_names.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace seiche
{
  namespace
  {
    constexpr double pause = 1.; // between two writes [s]
  }

  ProgressFile::ProgressFile(const std::string &output_directory)
    : directory(output_directory)
  {}

  void
  ProgressFile::update(const Values &now, const double wall_time)
  {
    values = now;
    if (written >= 0. && wall_time - written < pause)
      return;
    written = wall_time;
    write("running");
  }

  void
  ProgressFile::end(const std::string &state)
  {
    values.seconds_left = 0.;
    write(state);
  }

  void
  ProgressFile::write(const std::string &state) const
  {
    if (directory.empty())
      return;
    nlohmann::ordered_json text;
    text["state"]        = state;
    text["time"]         = values.time;
    text["end_time"]     = values.end_time;
    text["dt"]           = values.dt;
    text["seconds_left"] = nullptr;
    if (std::isfinite(values.seconds_left))
      text["seconds_left"] = std::round(values.seconds_left);
    checked_file::write(directory + "/" + result_names::progress,
                        [&](std::ostream &stream) {
                          stream << text.dump(2) << '\n';
                        });
  }
} // namespace seiche
