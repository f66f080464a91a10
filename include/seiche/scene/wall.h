// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_h
#define seiche_scene_wall_h

#include <seiche/scene/expression.h>
#include <seiche/shapes/shape.h>
#include <seiche/utilities/box_face.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/point.h>

#include <cctype>
#include <memory>
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
   * @brief A wall: a side of the domain's box, or the faces of an obstacle. It
   * is asked for its distance, normal, velocity and condition.
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
    double        friction  = 0.;    ///< skin friction coefficient [-]
    std::string   velocity_text;     ///< expressions, along itself [m/s]
    std::string   displacement_text; ///< expression, of a side [m]

    /// Its box at the start [m]; that of a side is flat.
    dealii::Point<dim> lower_corner, upper_corner;

    /// Make shape and motion of what was read; @p input must outlive the wall.
    /// InputError for what is no expression.
    void
    build(const InputFile &input);

    /// InputError if it moves in a way that its condition does not allow, or
    /// that is not defined in the box @p domain up to @p end_time [s].
    void
    check(const InputFile                &input,
          const dealii::BoundingBox<dim> &domain,
          const double                    end_time) const;

    /// False for a periodic side, which is the same place as its opposite.
    bool
    exists() const
    {
      return condition != WallCondition::periodic;
    }

    /// False where the fluid passes: open and periodic sides.
    bool
    is_closed() const
    {
      return exists() && condition != WallCondition::open;
    }

    /// Signed distance at time @p t [m]: positive in the fluid.
    double
    distance(const dealii::Point<dim> &x, const double t) const;

    /// Unit vector into the fluid at the place nearest to @p x.
    dealii::Tensor<1, dim>
    normal(const dealii::Point<dim> &x, const double t) const;

    /// Of a no-slip wall along itself [m/s].
    dealii::Tensor<1, dim>
    sliding_velocity(const dealii::Point<dim> &x, const double t) const;

    /// The same and, for a side that is displaced, its velocity along the
    /// normal: a difference over a small part of @p dt [s] after @p t.
    dealii::Tensor<1, dim>
    velocity(const dealii::Point<dim> &x,
             const double              t,
             const double              dt) const;

    /// Of a side along its coordinate [m]; zero for walls at rest.
    double
    displacement(const double t) const
    {
      return way ? way->value(dealii::Point<dim>(), t) : 0.;
    }

    /// True if it is displaced; if it moves along itself.
    bool
    is_displaced() const
    {
      return way != nullptr;
    }
    bool
    slides() const
    {
      return sliding != nullptr;
    }

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
    /// Where the wall had a place that is @p x at time @p t.
    dealii::Point<dim>
    at_start(dealii::Point<dim> x, const double t) const;

    std::shared_ptr<const Shape<dim>>      shape;   // at the start
    std::shared_ptr<const Expression<dim>> sliding; // along itself, or null
    std::shared_ptr<const Expression<dim>> way;     // of a side, or null

    void
    check_sliding(const InputFile &input, const double end_time) const;

    static std::string
    capital(std::string word)
    {
      word[0] = std::toupper(word[0]);
      return word;
    }
  };
} // namespace seiche

#endif
