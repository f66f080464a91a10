// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_condition_table_h
#define seiche_scene_wall_condition_table_h

#include <seiche/scene/grid_parameters.h>

#include <array>

namespace seiche
{
  /// All that differs between conditions by name: a row each.
  struct WallConditionEntry
  {
    const char   *name;
    WallCondition condition;
    const char   *text;
    bool          of_obstacles; ///< may have it
    const char   *line;         ///< SVG style in pictures of a scene
  };

  constexpr std::array<WallConditionEntry, 5> wall_condition_table = {
    {{"slip",
      WallCondition::slip,
      "no flow to or from it",
      true,
      "stroke:#222;stroke-width:2"},
     {"unilateral",
      WallCondition::unilateral,
      "the same, but the fluid may leave it",
      true,
      "stroke:#222;stroke-width:2;stroke-dasharray:8 3"},
     {"no-slip",
      WallCondition::no_slip,
      "the fluid sticks to it",
      true,
      "stroke:#222;stroke-width:5"},
     {"open",
      WallCondition::open,
      "fluid may leave the domain",
      false,
      "stroke:#2a8f4f;stroke-width:2;stroke-dasharray:2 4"},
     {"periodic",
      WallCondition::periodic,
      "what leaves here enters at the opposite side, which must be periodic "
      "too",
      false,
      "stroke:#8a8a8a;stroke-width:1;stroke-dasharray:1 4"}}};
} // namespace seiche

#endif
