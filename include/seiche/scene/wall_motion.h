// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_motion_h
#define seiche_scene_wall_motion_h

#include <seiche/scene/background_grid.h>
#include <seiche/scene/expression.h>

#include <array>
#include <functional>
#include <optional>

namespace seiche
{
  /**
   * @brief Sides of the box that move along their normal, as pistons: their
   * displacement in time, and the grid that follows them (doc/theory.md (8.4)).
   *
   * Grid lines between a moving side and the obstacle that is nearest to it in
   * its direction, or the opposite side, are stretched alike; obstacles stay.
   */
  template <int dim>
  class WallMotion
  {
  public:
    /// @p input must outlive the object. Throws InputError for what is no
    /// expression of t, does not begin with zero, or leaves too little room
    /// before @p end_time [s].
    WallMotion(const GridParameters<dim> &parameters,
               const InputFile           &input,
               const double               end_time);

    /// True if some side moves.
    bool
    any() const;

    bool
    moves(const unsigned int side) const
    {
      return expressions[side].has_value();
    }

    /// Along the coordinate [m], [m/s]; zero of a side at rest. The velocity
    /// is a difference within a small part of @p dt after @p time.
    double
    displacement(const unsigned int side, const double time) const;
    double
    velocity(const unsigned int side, const double time, const double dt) const;

    /// The most that a side moves in a step from @p time [m], which ends with
    /// the run.
    double
    largest_way(const double time, const double dt) const;

    /// The box of the grid at @p time.
    dealii::BoundingBox<dim>
    box(const double time) const;

    /// Place at @p time of the grid line that was at @p place [m].
    double
    line(const unsigned int direction,
         const double       place,
         const double       time) const;

    /// line() of all grid lines at @p time; the object must outlive it.
    std::function<double(const unsigned int, const double)>
    lines(const double time) const
    {
      return [this, time](const unsigned int direction, const double place) {
        return line(direction, place, time);
      };
    }

  private:
    void
    check(const GridParameters<dim> &parameters,
          const InputFile           &input,
          const unsigned int         side) const;

    std::array<std::optional<Expression<dim>>, 2 * dim> expressions;
    std::array<std::array<double, 2>, dim> sides; ///< at the start [m]
    std::array<std::array<double, 2>, dim> fixed; ///< first, last fixed line
    const double                           last_time; ///< of the run [s]
  };
} // namespace seiche

#endif
