// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_catenary_h
#define seiche_scene_catenary_h

namespace seiche
{
  /// A line that hangs by its weight between two ends, in a vertical plane.
  struct Catenary
  {
    double length;    ///< without tension [m]
    double weight;    ///< in the water [N/m]
    double stiffness; ///< E A [N]

    struct Ends
    {
      double horizontal; ///< force at both [N]
      double vertical;   ///< at the upper one, downwards [N]
      double anchor;     ///< tension at the lower one [N]
      double lying;      ///< length on the ground [m]
    };

    /**
     * @brief The forces in equilibrium, of a line whose upper end is @p across
     * >= 0 beside and @p up above its lower one [m] (Jonkman 2007, eq. 2-35 to
     * 2-38), to round-off.
     *
     * @p on_ground: a level ground without friction bears the line at the lower
     * end; it counts if up >= 0. NumericalError if Newton's iteration fails.
     */
    Ends
    ends(const double across, const double up, const bool on_ground) const;
  };
} // namespace seiche

#endif
