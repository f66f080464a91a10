// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_jumps_h
#define seiche_scene_jumps_h

#include <cmath>

namespace seiche
{
  /**
   * True if a motion place(t) goes by more than @p slow between two times [s],
   * most of it at once.
   */
  template <typename Place>
  bool
  jumps(const Place &place, double begin, double end, const double slow)
  {
    constexpr unsigned int n_halvings = 40;
    const double           way        = std::abs(place(end) - place(begin));
    if (way < slow)
      return false;
    // towards the half in which it moves farther: what is smooth halves
    for (unsigned int i = 0; i < n_halvings; ++i)
      {
        const double middle = 0.5 * (begin + end);
        if (std::abs(place(middle) - place(begin)) >
            std::abs(place(end) - place(middle)))
          end = middle;
        else
          begin = middle;
      }
    return std::abs(place(end) - place(begin)) > 0.1 * way;
  }
} // namespace seiche

#endif
