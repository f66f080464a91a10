// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_h
#define seiche_scene_wall_h

#include <seiche/utilities/box_face.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <cctype>
#include <string>

namespace seiche
{
  /// What a wall does to the displacement of the fluid that touches it.
  enum class WallCondition
  {
    slip,       ///< normal component fixed
    unilateral, ///< the same, but the fluid may leave the wall
    no_slip,    ///< all components fixed
    open,       ///< nothing fixed; points that cross it leave as outflow
    periodic    ///< no wall: the opposite side is the same place
  };

  /**
   * @brief A wall: a side of the domain's box, or the faces of an obstacle.
   *
   * Its number is its place in GridParameters::walls and the boundary id of its
   * faces: that of deal.II for a side, then those of obstacles.
   */
  template <int dim>
  struct Wall
  {
    std::string   name; ///< e.g. "left", or that of the obstacle
    unsigned int  number    = dealii::numbers::invalid_unsigned_int;
    WallCondition condition = WallCondition::slip;
    double        friction  = 0.; ///< skin friction coefficient [-]
    std::string   velocity;       ///< expressions, along itself [m/s]
    std::string   displacement;   ///< expression, of a side [m]

    /// Its box at the start [m]; that of a side is flat.
    dealii::Point<dim> lower_corner, upper_corner;

    bool
    is_side() const
    {
      return number < 2 * dim;
    }

    /// Of the domain's box.
    BoxFace
    side() const
    {
      return number;
    }

    dealii::BoundingBox<dim>
    box() const
    {
      return dealii::BoundingBox<dim>({lower_corner, upper_corner});
    }

    /// Entry of a side in subsection "Walls": its name with a capital letter.
    std::string
    side_entry() const
    {
      return capital(name);
    }

    /// Path of one of its entries (velocity, friction, displacement, lower
    /// corner, ...), or of the condition of a side.
    std::string
    path(const std::string &entry = "") const
    {
      if (!is_side())
        return "Obstacle " + name + "/" + capital(entry);
      return "Walls/" + side_entry() + (entry.empty() ? "" : " " + entry);
    }

  private:
    static std::string
    capital(std::string word)
    {
      word[0] = std::toupper(word[0]);
      return word;
    }
  };
} // namespace seiche

#endif
