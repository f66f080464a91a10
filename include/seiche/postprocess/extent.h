// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_extent_h
#define seiche_postprocess_extent_h

#include <seiche/postprocess/postprocessor.h>

#include <limits>
#include <vector>

namespace seiche
{
  /**
   * @brief How far something reaches at the end of a step: the fluid, or spray
   * (FluidExtent). All values are those of this rank; vertical is the last
   * direction.
   */
  template <int dim>
  class Extent
  {
  public:
    /// In place of a coordinate: there is nothing.
    static constexpr double none = -std::numeric_limits<double>::max();

    virtual ~Extent() = default;

    /// Largest @p sign x_axis [m] at heights from @p lowest on.
    virtual double
    farthest(const unsigned int axis,
             const double       sign,
             const double       lowest) const = 0;

    /// Height [m] at a place whose vertical coordinate is ignored; @p width: of
    /// what single points stand for, on either side.
    virtual double
    level(const dealii::Point<dim> &place, const double width) const = 0;

    /// The same of the surface that stood there at the start of the step: for a
    /// place, at a wall that has let go, from which the fluid has just moved
    /// away.
    virtual double
    level_left(const dealii::Point<dim> & /*place*/) const
    {
      return none;
    }

    /// Largest height at which a wall, of this boundary id, is wet [m].
    virtual double
    wet_height(const unsigned int wall) const = 0;

    /// Integrals over the upper side.
    struct Surface
    {
      double area   = 0.; ///< of its horizontal projection [m^(dim-1)]
      double volume = 0.; ///< between it and the height zero [m^dim]
    };
    virtual Surface
    surface() const = 0;
  };
} // namespace seiche

#endif
