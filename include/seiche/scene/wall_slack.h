// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_slack_h
#define seiche_scene_wall_slack_h

namespace seiche
{
  /// Places of entries coincide, and lie on a wall, if they differ by no more
  /// than this [m]: the rounding of what users compute. @p length: of the
  /// domain in the direction that is compared [m]. What a run computes itself,
  /// points above all, is located more sharply (CellLocator).
  inline double
  wall_slack(const double length)
  {
    return 1e-9 * length;
  }
} // namespace seiche

#endif
