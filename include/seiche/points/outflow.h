// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_points_outflow_h
#define seiche_points_outflow_h

#include <seiche/utilities/state_archive.h>

#include <cstdint>

namespace seiche
{
  /// What left the domain since the start, and what was kept from it.
  struct Outflow
  {
    std::uint64_t points = 0;  ///< through open sides
    double        mass   = 0.; ///< of these [kg]
    /// Times that a point was set on a wall that it had crossed.
    std::uint64_t set_on_walls = 0;

    /// For a checkpoint. Local.
    void
    save_or_load(StateArchive &archive)
    {
      archive("outflow points", points);
      archive("outflow mass", mass);
      archive("points put back", set_on_walls);
    }
  };
} // namespace seiche

#endif
