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
    pressure
  };

  inline constexpr unsigned int n_point_columns = 8;

  struct PointColumnInfo
  {
    PointColumn  column;
    const char  *name;
    unsigned int rank; // tensor rank: 0, 1, 2 -> 1, dim, dim*dim components
    const char  *unit;
  };

  /// THE table of point columns: name, shape, unit.
  inline constexpr std::array<PointColumnInfo, n_point_columns>
    point_column_table = {
      {{PointColumn::position, "position", 1, "m"},
       {PointColumn::velocity, "velocity", 1, "m/s"},
       {PointColumn::velocity_gradient, "velocity_gradient", 2, "1/s"},
       {PointColumn::acceleration, "acceleration", 1, "m/s^2"},
       {PointColumn::volume_ratio, "volume_ratio", 0, "-"}, // J = V/V0
       {PointColumn::mass, "mass", 0, "kg"},                // per m depth in 2D
       {PointColumn::initial_volume, "initial_volume", 0, "m^dim"},
       {PointColumn::pressure, "pressure", 0, "Pa"}}};

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
