// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_scene_scene_map_h
#define seiche_scene_scene_map_h

#include <seiche/scene/fluid_body.h>
#include <seiche/scene/grid_parameters.h>
#include <seiche/utilities/box_face.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace seiche
{
  /**
   * @brief What is where at the start: the domain cut into some thousands of
   * boxes, for estimates and pictures that must not cost a grid or points.
   *
   * Faces of bodies' boxes, of obstacles and of grid segments are lines of the
   * map, so that volumes of boxes are exact (of obstacles up to some dozens of
   * them); of other shapes a piece counts as what is in its middle.
   */
  template <int dim>
  class SceneMap
  {
  public:
    using Index = std::array<unsigned int, dim>;

    /// Beside the index of a fluid body.
    static constexpr int air = -1, obstacle = -2;

    struct Piece
    {
      Index                  index;
      dealii::Point<dim>     centre; ///< [m]
      dealii::Tensor<1, dim> extent; ///< [m]
      double                 volume; ///< [m^dim]
      int                    content;
    };

    /// About @p per_direction pieces in each direction, at most twice as many.
    /// Where bodies overlap, the first one counts. Local.
    SceneMap(const GridParameters<dim>         &grid,
             const std::vector<FluidBody<dim>> &bodies,
             const unsigned int                 per_direction);

    void
    for_each(const std::function<void(const Piece &)> &visit) const;

    /// Content of the neighbour across face 2 d (below) or 2 d + 1 (above);
    /// obstacle beyond the domain.
    int
    neighbor(const Index &index, const BoxFace face) const;

    /// Places that cut the domain in a direction, both ends included [m].
    const std::vector<double> &
    lines(const unsigned int direction) const
    {
      return cuts[direction];
    }

  private:
    void
    make_lines(const GridParameters<dim>         &grid,
               const std::vector<FluidBody<dim>> &bodies,
               const unsigned int                 per_direction);

    std::size_t
    position(const Index &index) const;

    std::array<std::vector<double>, dim> cuts;
    std::vector<int>                     contents;
  };

  /// A body without what obstacles and earlier bodies take, seen by samples.
  template <int dim>
  struct SampledBody
  {
    std::vector<dealii::Point<dim>> places; ///< samples in it [m]
    double                          volume; ///< [m^dim]
    double resolution;  ///< of one sample: what is smaller may be missed
    bool   is_whole;    ///< the volume is that of its box, exactly
    double bottom, top; ///< [m]
    bool   ends_at_box; ///< both are those of its box, exactly
  };

  /// All bodies, by some 10^5 samples in their own boxes: a small body in a
  /// large domain is seen. Local.
  template <int dim>
  std::vector<SampledBody<dim>>
  sample_bodies(const GridParameters<dim>         &grid,
                const std::vector<FluidBody<dim>> &bodies);
} // namespace seiche

#endif
