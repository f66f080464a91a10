// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wrapped_h
#define seiche_scene_wrapped_h

#include <cmath>

namespace seiche
{
  /// Where a coordinate is between two periodic sides [m]: half open, [lower,
  /// upper).
  inline double
  wrapped(const double x, const double lower, const double upper)
  {
    if ((x >= lower && x < upper) || !std::isfinite(x))
      return x;
    const double length  = upper - lower;
    const double periods = std::floor((x - lower) / length);
    // measured from the other side, so that a side goes to a side exactly
    const double result = lower + ((x - upper) - (periods - 1.) * length);
    return result < lower || result >= upper ? lower : result; // round-off
  }
} // namespace seiche

#endif
