// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_gathered_points_h
#define seiche_postprocess_gathered_points_h

#include <seiche/points/point_cloud.h>
#include <seiche/postprocess/hdf5_image.h>

#include <utility>
#include <vector>

namespace seiche
{
  /**
   * @brief All columns of the points of all ranks, on rank 0, in the order of
   * their ids: they do not depend on the number of ranks.
   */
  template <int dim>
  class GatheredPoints
  {
  public:
    /// Collective; the others keep nothing.
    explicit GatheredPoints(const PointCloud<dim> &points);

    /// Datasets `id`, and every column under its name in the table of
    /// columns, [n] or [n][components], with attribute `unit`. Rank 0.
    void
    write(Hdf5Image &image) const;

  private:
    std::vector<std::uint64_t>                                   ids;
    std::vector<std::pair<PointColumnInfo, std::vector<double>>> columns;
  };
} // namespace seiche

#endif
