// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_grid_motion_h
#define seiche_scene_grid_motion_h

#include <seiche/scene/grid_parameters.h>

#include <array>
#include <functional>

namespace seiche
{
  /// Place of a grid line [m], from its direction and its place at the start.
  using LinePlace = std::function<double(const unsigned int, const double)>;

  /**
   * @brief The grid that follows sides of the box that move along their normal,
   * as pistons (doc/theory.md (8.4)).
   *
   * Grid lines between a moving side and the obstacle that is nearest to it in
   * its direction, or the opposite side, are stretched alike; obstacles stay.
   */
  template <int dim>
  class GridMotion
  {
  public:
    /// @p parameters must outlive the object; a run ends at @p end_time [s].
    GridMotion(const GridParameters<dim> &parameters, const double end_time);

    /// InputError if a side that moves jumps or leaves too little room before
    /// the end.
    void
    check(const InputFile &input) const;

    /// True if some side moves.
    bool
    any() const;

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
    LinePlace
    lines(const double time) const
    {
      return [this, time](const unsigned int direction, const double place) {
        return line(direction, place, time);
      };
    }

  private:
    void
    check_side(const InputFile &input, const Wall<dim> &wall) const;

    const GridParameters<dim>             &parameters;
    std::array<std::array<double, 2>, dim> fixed; ///< first, last fixed line
    const double                           last_time; ///< of the run [s]
  };
} // namespace seiche

#endif
