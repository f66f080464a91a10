// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_point_columns_h
#define seiche_points_point_columns_h

#include <array>
#include <vector>

namespace seiche
{
  /// What a material point may carry.
  enum class PointColumn : unsigned int
  {
    position,
    velocity,
    velocity_gradient,
    acceleration,
    volume_ratio,
    mass,
    initial_volume,
    pressure,
    material
  };

  inline constexpr unsigned int n_point_columns = 9;

  /// What becomes of a column where two points are merged.
  enum class MergeRule
  {
    by_mass,   ///< mean, weighted by mass
    by_volume, ///< mean, weighted by initial volume
    sum,
    same ///< only points with equal values are merged
  };

  struct PointColumnInfo
  {
    PointColumn  column;
    const char  *name;
    unsigned int rank; // tensor rank: 0, 1, 2 -> 1, dim, dim*dim components
    const char  *unit;
    MergeRule    merge;
  };

  /// THE table of point columns: name, shape, unit, rule of mergers.
  inline constexpr std::array<PointColumnInfo, n_point_columns>
    point_column_table = {
      {{PointColumn::position, "position", 1, "m", MergeRule::by_mass},
       {PointColumn::velocity, "velocity", 1, "m/s", MergeRule::by_mass},
       {PointColumn::velocity_gradient,
        "velocity_gradient",
        2,
        "1/s",
        MergeRule::by_mass},
       {PointColumn::acceleration,
        "acceleration",
        1,
        "m/s^2",
        MergeRule::by_mass},
       // J = V/V0
       {PointColumn::volume_ratio,
        "volume_ratio",
        0,
        "-",
        MergeRule::by_volume},
       // per m depth in 2D
       {PointColumn::mass, "mass", 0, "kg", MergeRule::sum},
       {PointColumn::initial_volume,
        "initial_volume",
        0,
        "m^dim",
        MergeRule::sum},
       {PointColumn::pressure, "pressure", 0, "Pa", MergeRule::by_volume},
       // number in the scene's list, with several materials
       {PointColumn::material, "material", 0, "-", MergeRule::same}}};

  /// Number of components of a column.
  inline unsigned int
  n_components(const PointColumn column, const unsigned int dim)
  {
    const unsigned int rank =
      point_column_table[static_cast<unsigned int>(column)].rank;
    return rank == 0 ? 1 : (rank == 1 ? dim : dim * dim);
  }
} // namespace seiche

#endif
