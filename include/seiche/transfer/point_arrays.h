// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_transfer_point_arrays_h
#define seiche_transfer_point_arrays_h

#include <seiche/points/point_cloud.h>

#include <array>
#include <type_traits>

namespace seiche
{
  /**
   * @brief Raw pointers to the columns of a point cloud, for the loops of the
   * transfers; null for a column that is absent.
   *
   * @p Cloud is PointCloud<dim> or its const version, which gives pointers to
   * const. Valid until the next insertion or locate().
   */
  template <int dim, typename Cloud>
  struct PointArrays
  {
    using Pointer =
      std::conditional_t<std::is_const<Cloud>::value, const double *, double *>;

    std::array<Pointer, dim>       position;
    std::array<Pointer, dim>       velocity;
    std::array<Pointer, dim>       acceleration; // or null
    std::array<Pointer, dim * dim> gradient;     // row-major, or null
    Pointer                        volume_ratio;
    Pointer                        mass;
    Pointer                        pressure;

    explicit PointArrays(Cloud &points)
      : volume_ratio(points.data(PointColumn::volume_ratio))
      , mass(points.data(PointColumn::mass))
      , pressure(points.data(PointColumn::pressure))
    {
      const bool with_acceleration = points.has(PointColumn::acceleration);
      const bool with_gradient     = points.has(PointColumn::velocity_gradient);
      for (unsigned int d = 0; d < dim; ++d)
        {
          position[d]     = points.data(PointColumn::position, d);
          velocity[d]     = points.data(PointColumn::velocity, d);
          acceleration[d] = with_acceleration ?
                              points.data(PointColumn::acceleration, d) :
                              nullptr;
        }
      for (unsigned int c = 0; c < dim * dim; ++c)
        gradient[c] = with_gradient ?
                        points.data(PointColumn::velocity_gradient, c) :
                        nullptr;
    }
  };
} // namespace seiche

#endif
