// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_wall_velocity_h
#define seiche_scene_wall_velocity_h

#include <seiche/scene/background_grid.h>
#include <seiche/scene/expression.h>

#include <optional>
#include <vector>

namespace seiche
{
  /**
   * @brief Velocities of no-slip walls that move along themselves: expressions
   * of position and time, by boundary id.
   */
  template <int dim>
  class WallVelocity
  {
  public:
    /// @p input must outlive the object. Throws InputError for what is no
    /// expression, for walls that are not no-slip, and for motion normal to a
    /// side of the domain at its centre, at times up to @p end_time [s].
    WallVelocity(const GridParameters<dim> &parameters,
                 const InputFile           &input,
                 const double               end_time);

    /// True if some wall has an expression.
    bool
    any() const;

    /// [m/s] of a wall at a place [m] and time [s]; zero at rest.
    dealii::Tensor<1, dim>
    value(const unsigned int        wall,
          const dealii::Point<dim> &x,
          const double              t) const;

  private:
    std::vector<std::optional<Expression<dim>>> expressions; // by boundary id
  };
} // namespace seiche

#endif
