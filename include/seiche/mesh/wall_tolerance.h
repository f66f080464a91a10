// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_mesh_wall_tolerance_h
#define seiche_mesh_wall_tolerance_h

namespace seiche
{
  /// Way of a point through a wall [cells] up to which it counts as on it and
  /// is put there: round-off of an update of the position.
  constexpr double wall_tolerance = 1e-10;
} // namespace seiche

#endif
