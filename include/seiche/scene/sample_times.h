// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_sample_times_h
#define seiche_scene_sample_times_h

#include <vector>

namespace seiche
{
  /// Times [s] from 0 to the end of a run, evenly, at which what walls are
  /// told to do is looked at before the run.
  inline std::vector<double>
  sample_times(const double end_time)
  {
    constexpr unsigned int n_intervals = 1000;
    std::vector<double>    times;
    for (unsigned int i = 0; i <= n_intervals; ++i)
      times.push_back(i * end_time / n_intervals);
    return times;
  }
} // namespace seiche

#endif
